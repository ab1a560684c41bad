#include <gtest/gtest.h>

#include <fairlight/stats/seed.h>
#include <fairlight/validation/audit/fault_audit.h>
#include <fairlight/validation/registry.h>

namespace fairlight {
namespace {

TEST(Faults, StandInForRowsOfTheRegistry) {
  const Manifest manifest = manifest_of({{.seed = 0}});
  for (const Fault& fault : fault_catalogue()) {
    EXPECT_FALSE(fault.claims.empty()) << fault.name;
    for (const Claim& claim : fault.claims) EXPECT_NO_THROW(manifest.trial(claim.name)) << claim.name;
  }
}

// A short form of `fairlight audit faults`.
TEST(Faults, AreAllBiasedInEveryClaimThatTheyStandIn) {
  const Conformance conformance{{.seed = fresh_seed()}, 2};
  for (const FaultOutcome& outcome : audit_faults(conformance, 2)) {
    EXPECT_EQ(outcome.caught, outcome.seeds)
        << outcome.fault->name << " in " << outcome.claim << ", seed " << seed_text(conformance.terms.seed);
  }
}

}  // namespace
}  // namespace fairlight

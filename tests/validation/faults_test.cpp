#include <set>

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
    for (const Claim& claim : fault.passed) EXPECT_NO_THROW(manifest.trial(claim.name)) << claim.name;
  }
}

TEST(Faults, HaveNamesOfTheirOwnAClassAndASource) {
  std::set<std::string> names, classes;
  for (const Fault& fault : fault_catalogue()) {
    EXPECT_TRUE(names.insert(fault.name).second) << fault.name;
    EXPECT_FALSE(fault.kind.empty()) << fault.name;
    EXPECT_FALSE(fault.source.empty()) << fault.name;
    classes.insert(fault.kind);
  }
  EXPECT_GE(names.size(), 60u);
  EXPECT_GE(classes.size(), 25u);
}

// A short form of `fairlight audit faults`. A fault that the catalogue expects to survive is caught nowhere, or its reason is stale.
TEST(Faults, AreAllBiasedInEveryClaimThatTheyStandIn) {
  const Conformance conformance{{.seed = fresh_seed()}, 2};
  for (const FaultOutcome& outcome : audit_faults(conformance, 1)) {
    const bool survives = !outcome.fault->survives.empty();
    EXPECT_EQ(outcome.caught, survives ? 0 : outcome.seeds)
        << outcome.fault->name << " in " << outcome.claim->name << ", seed " << seed_text(conformance.terms.seed);
  }
}

// Pairs of wrongs that cancel, and wrongs of second order, where nobody sees them. At four times the margin, a sixteenth of the draws.
TEST(Faults, AreCertifiedWhereTheyCancel) {
  const Manifest manifest = manifest_of({{.seed = fresh_seed()}});
  for (const Fault& fault : fault_catalogue()) {
    for (const Claim& claim : fault.passed) {
      Trial trial = manifest.trial(claim.name);
      trial.margin *= 4;
      EXPECT_EQ(claim.check(trial).verdict, Verdict::certified)
          << fault.name << " in " << claim.name << ", seed " << seed_text(trial.seed);
    }
  }
}

TEST(FaultAudit, ListsWhatNoClaimCatchesEveryTimeWithTheReason) {
  std::vector<FaultOutcome> outcomes;
  for (const Fault& fault : fault_catalogue()) {
    const int caught = fault.survives.empty() ? 3 : 0;
    outcomes.push_back({.fault = &fault, .claim = &fault.claims[0], .caught = caught, .seeds = 3});
  }
  for (const Survivor& survivor : survivors(outcomes)) {
    EXPECT_TRUE(survivor.expected) << survivor.fault->name;
    EXPECT_EQ(survivor.reason, survivor.fault->survives);
  }
  outcomes[0].caught = 2;
  const Survivor first = survivors(outcomes).front();
  EXPECT_EQ(first.fault, &fault_catalogue()[0]);
  EXPECT_FALSE(first.expected);
  EXPECT_NE(first.reason.find("caught 2 times of 3"), std::string::npos) << first.reason;
}

}  // namespace
}  // namespace fairlight

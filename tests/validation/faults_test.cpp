#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <support/temporary_folder.h>

#include <fairlight/stats/seed.h>
#include <fairlight/validation/audit/fault_audit.h>
#include <fairlight/validation/run/registry.h>

namespace fairlight {
namespace {

// Those that docs/faults.md has in its matrix: a row names one after its class.
std::set<std::string> faults_of_the_page() {
  static const std::regex row(R"(^\|[^|]*\| `([^`]+)` \|.*$)");
  std::istringstream page(testing::read_file(FAIRLIGHT_SOURCE_DIR "/docs/faults.md"));
  std::set<std::string> names;
  std::smatch match;
  for (std::string line; std::getline(page, line);) {
    if (std::regex_match(line, match, row)) names.insert(match[1]);
  }
  return names;
}

TEST(Faults, StandInForRowsOfTheRegistry) {
  const Manifest manifest = manifest_of({{.seed = 0}});
  for (const Fault& fault : fault_catalogue()) {
    EXPECT_FALSE(fault.claims.empty()) << fault.name;
    for (const Claim& claim : fault.claims) EXPECT_NO_THROW(manifest.trial(claim.name)) << claim.name;
    for (const Claim& claim : fault.passed) EXPECT_NO_THROW(manifest.trial(claim.name)) << claim.name;
  }
}

// None of the page may be missing, and none of the catalogue.
TEST(Faults, HaveNamesOfTheirOwnAClassASourceAndARowOnThePage) {
  std::set<std::string> names;
  for (const Fault& fault : fault_catalogue()) {
    EXPECT_TRUE(names.insert(fault.name).second) << fault.name;
    EXPECT_FALSE(fault.kind.empty()) << fault.name;
    EXPECT_FALSE(fault.source.empty()) << fault.name;
  }
  EXPECT_EQ(names, faults_of_the_page());
}

// A short form of `fairlight audit faults`. A fault that the catalogue expects to survive is caught nowhere, or its reason is stale.
TEST(Faults, AreAllBiasedInEveryClaimThatTheyStandIn) {
  const RunOptions run_options{{.seed = fresh_seed()}, 2};
  const std::vector<FaultOutcome> outcomes = audit_faults(run_options, 1);
  std::size_t rows = 0;
  for (const Fault& fault : fault_catalogue()) rows += fault.claims.size();
  EXPECT_EQ(outcomes.size(), rows);
  for (const FaultOutcome& outcome : outcomes) {
    EXPECT_EQ(outcome.seeds, 1) << outcome.fault->name;
    const bool survives = !outcome.fault->survives.empty();
    EXPECT_EQ(outcome.caught, survives ? 0 : outcome.seeds)
        << outcome.fault->name << " in " << outcome.claim->name << ", seed " << seed_text(run_options.terms.seed);
  }
}

// Pairs of wrongs that cancel, and wrongs of second order, where nobody sees them. At four times the margin, a sixteenth of the draws.
TEST(Faults, AreCertifiedWhereTheyCancel) {
  const Manifest manifest = manifest_of({{.seed = fresh_seed()}});
  int passed = 0;
  for (const Fault& fault : fault_catalogue()) {
    for (const Claim& claim : fault.passed) {
      ++passed;
      Trial trial = manifest.trial(claim.name);
      trial.margin *= 4;
      EXPECT_EQ(claim.check(trial).verdict, Verdict::certified)
          << fault.name << " in " << claim.name << ", seed " << seed_text(trial.seed);
    }
  }
  EXPECT_GT(passed, 0);
}

TEST(FaultAudit, ListsWhatNoClaimCatchesEveryTimeWithTheReason) {
  std::vector<FaultOutcome> outcomes;
  for (const Fault& fault : fault_catalogue()) {
    const int caught = fault.survives.empty() ? 3 : 0;
    outcomes.push_back({.fault = &fault, .claim = &fault.claims[0], .caught = caught, .seeds = 3});
  }
  const auto expected =
      std::ranges::count_if(fault_catalogue(), [](const Fault& f) { return !f.survives.empty(); });
  EXPECT_GT(expected, 0);
  EXPECT_EQ(std::ssize(survivors(outcomes)), expected);
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

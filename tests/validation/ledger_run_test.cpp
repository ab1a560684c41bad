#include <algorithm>

#include <gtest/gtest.h>
#include <support/temporary_folder.h>

#include <fairlight/validation/run/ledger_run.h>
#include <fairlight/validation/run/registry.h>

namespace fairlight {
namespace {

using testing::TemporaryFolder;

const Claim& claim() { return *select_claims({"stream.product"}).front(); }

// A run that certified its margin, of which the first margin_levels show this much of a bias and of none.
std::vector<Outcome> outcome_of(double above_reference, double shown) {
  Outcome outcome{&claim(), {}, 0};
  outcome.finding.verdict = Verdict::certified;
  outcome.evidence.margin_grid = {first_level(0.01), {std::vector(12, Wealth{above_reference, 0, shown, shown})}};
  return {outcome};
}

RunOptions with_seed(std::uint64_t seed) {
  RunOptions run_options{{.seed = seed, .margin = 0.01}, 1};
  run_options.evidence = true;
  return run_options;
}

// Adds a run without components.
void add(LedgerRun& run, std::vector<Outcome>& outcomes, std::uint64_t seed) {
  std::vector<ComponentOutcome> none;
  run.add(outcomes, none, with_seed(seed));
}

std::string summary(const LedgerRun& run) {
  std::FILE* file = std::tmpfile();
  run.print(file);
  std::rewind(file);
  char text[256] = "";
  if (std::fgets(text, sizeof text, file) == nullptr) text[0] = '\0';
  std::fclose(file);
  return text;
}

// The share of the budget and the mixture ask for a log wealth between 18 and 27.
TEST(LedgerRun, CallsAClaimBiasedWhenItsRunsTogetherAre) {
  const TemporaryFolder folder;
  LedgerRun run(folder / "l", {&claim()}, this_build());
  for (std::uint64_t seed : {1u, 2u, 2u, 3u}) {
    auto outcomes = outcome_of(9, 1);
    add(run, outcomes, seed);
    EXPECT_EQ(outcomes[0].finding.verdict, seed < 3 ? Verdict::certified : Verdict::biased) << seed;
    EXPECT_EQ(outcomes[0].finding.note.find("3 runs") != std::string::npos, seed == 3) << outcomes[0].finding.note;
  }
}

// What the packets of one instruction set show says nothing of those of another.
TEST(LedgerRun, KeepsInstructionSetsApart) {
  Claim sse2 = claim(), avx2 = claim();
  sse2.instructions = "sse2";
  avx2.instructions = "avx2";
  const TemporaryFolder folder;
  LedgerRun run(folder / "l", {&sse2, &avx2}, this_build());
  auto outcomes = outcome_of(0, 3);
  outcomes.push_back(outcomes[0]);
  outcomes[0].claim = &sse2;
  outcomes[1].claim = &avx2;
  add(run, outcomes, 1);
  EXPECT_EQ(outcomes[0].ledger->runs, 1);
  EXPECT_EQ(outcomes[1].ledger->runs, 1);
}

// Five runs of a claim show 15, less than a claim or a component is asked for; with three of another, 24.
TEST(LedgerRun, JudgesAComponentByAllItsClaims) {
  const std::string name = "CosineHemisphere";
  std::vector<const Claim*> claims;
  for (const Claim& each : registry()) {
    if (each.adds_up && std::ranges::find(each.subjects, name) != each.subjects.end()) claims.push_back(&each);
  }
  ASSERT_GE(claims.size(), 2u);
  const TemporaryFolder folder;
  LedgerRun run(folder / "l", {claims[0]}, this_build());
  for (std::size_t c : {0u, 1u}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      auto outcomes = outcome_of(3, 1);
      outcomes[0].claim = claims[c];
      std::vector<ComponentOutcome> components{{name, claims[0]->instructions, 2, Verdict::certified, false, 0.01}};
      run.add(outcomes, components, with_seed(seed));
      EXPECT_EQ(outcomes[0].finding.verdict, Verdict::certified);
      EXPECT_EQ(components[0].verdict == Verdict::biased, c == 1 && seed >= 3) << c << " " << seed;
      EXPECT_EQ(components[0].ledger->runs, c == 0 ? seed : 5);
    }
  }
}

TEST(LedgerRun, SaysHowMuchFinerAMarginIsCertified) {
  const TemporaryFolder folder;
  LedgerRun run(folder / "l", {&claim()}, this_build());
  auto outcomes = outcome_of(0, 3);
  add(run, outcomes, 1);
  EXPECT_NE(summary(run).find("1 runs: 0 of 1 claims"), std::string::npos) << summary(run);
  add(run, outcomes, 2);
  EXPECT_NE(summary(run).find("2 runs: 1 of 1 claims"), std::string::npos) << summary(run);
  EXPECT_EQ(outcomes[0].ledger->runs, 2);
  EXPECT_LT(outcomes[0].ledger->margin, 0.01 * claim().margin_factor);
}

TEST(LedgerRun, LeavesOutWhatHasNoEvidence) {
  const TemporaryFolder folder;
  LedgerRun run(folder / "l", {&claim()}, this_build());
  std::vector<Outcome> outcomes{{&claim(), {}, 0}};
  add(run, outcomes, 1);
  EXPECT_NE(summary(run).find("no claim"), std::string::npos) << summary(run);
  EXPECT_EQ(folder.files(), 0);
}

}  // namespace
}  // namespace fairlight

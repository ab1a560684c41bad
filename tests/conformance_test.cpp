#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

#include <fairlight/render/parallel.h>
#include <fairlight/stats/seed.h>
#include <fairlight/validation/report/report.h>
#include <fairlight/validation/run/registry.h>

namespace fairlight {
namespace {

// FAIRLIGHT_MARGIN coarsens the run where code is slow, under the sanitizers.
double margin() {
  const char* text = std::getenv("FAIRLIGHT_MARGIN");
  return text == nullptr ? Manifest::Terms{.seed = 0}.margin : std::stod(text);
}

// The one loop: everything that is claimed of the kit, with a fresh seed.
TEST(Conformance, EveryClaimIsCertified) {
  const RunOptions run_options{{.seed = fresh_seed(), .margin = margin()}, hardware_threads()};
  const auto outcomes = run_claims(select_claims({}), run_options);
  print_outcomes(stdout, outcomes, run_options);
  EXPECT_EQ(outcomes.size(), registry().size());
  EXPECT_EQ(overall(outcomes), Verdict::certified);
  const auto resting_on = [&](Guarantee guarantee) {
    return std::ranges::count_if(outcomes, [=](const Outcome& o) { return o.finding.guarantee == guarantee; });
  };
  const auto exact = resting_on(Guarantee::exact) + resting_on(Guarantee::exact_given_tail);
  EXPECT_GT(exact, 0);
  EXPECT_GE(exact, 9 * resting_on(Guarantee::asymptotic))
      << "at least nine tenths of the statistical claims are exact, some given their tails";
  for (const Outcome& o : outcomes) {
    const bool needs_note =
        o.finding.guarantee == Guarantee::asymptotic || o.finding.guarantee == Guarantee::exact_given_tail;
    EXPECT_FALSE(needs_note && o.finding.note.empty()) << o.claim->name << " does not say why it is not exact";
  }
}

// The other instruction sets that this machine has, more coarsely: what an instruction set does wrong, it does grossly.
TEST(Conformance, EveryInstructionSetIsCertified) {
  RunOptions run_options{{.seed = fresh_seed(), .margin = 4 * margin()}, hardware_threads()};
  run_options.instructions = claimed_instructions();
  run_options.instructions.pop_back();
  if (run_options.instructions.empty()) return;  // the widest alone, which is certified above
  std::vector<const Claim*> claims;
  for (const std::string& set : run_options.instructions) {
    for (const Claim& claim : registry(set)) claims.push_back(&claim);
  }
  const auto outcomes = run_claims(claims, run_options);
  print_outcomes(stdout, outcomes, run_options);
  EXPECT_EQ(overall(outcomes), Verdict::certified);
}

}  // namespace
}  // namespace fairlight

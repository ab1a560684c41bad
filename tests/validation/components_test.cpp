#include <algorithm>
#include <limits>

#include <boost/math/distributions/binomial.hpp>
#include <gtest/gtest.h>
#include <support/run_seed.h>

#include <fairlight/validation/audit/joint_kinds.h>
#include <fairlight/validation/run/components.h>
#include <fairlight/validation/run/registry.h>

namespace fairlight {
namespace {

const RunOptions quick{{.seed = 3, .margin = 0.01}, 1};

// Outcomes of the claims of a component that add up, with this evidence each.
std::vector<Outcome> outcomes_of(const std::string& component, const Wealth& wealth) {
  std::vector<Outcome> outcomes;
  for (const Claim& claim : registry()) {
    if (!claim.adds_up || std::ranges::find(claim.subjects, component) == claim.subjects.end()) continue;
    outcomes.push_back({&claim, {Verdict::certified}, 0});
    outcomes.back().evidence.margin_grid = {first_level(0.01), {std::vector(12, wealth)}};
  }
  return outcomes;
}

const ComponentOutcome& named(const std::vector<ComponentOutcome>& components, const std::string& name) {
  return *std::ranges::find(components, name, &ComponentOutcome::name);
}

TEST(Components, AreBiasedWhenTheirClaimsTogetherAre) {
  const auto outcomes = outcomes_of("CosineHemisphere", {6, -2, 1, 1});
  ASSERT_GE(outcomes.size(), 5u);
  const auto components = component_outcomes(outcomes, quick);
  const ComponentOutcome& cosine = named(components, "CosineHemisphere");
  EXPECT_EQ(cosine.claims, outcomes.size());
  EXPECT_EQ(cosine.verdict, Verdict::biased);
  EXPECT_TRUE(cosine.upward);
  EXPECT_EQ(overall(outcomes), Verdict::certified);
  EXPECT_EQ(overall(outcomes, components), Verdict::biased);
}

TEST(Components, SayTheLeastCommonBiasThatIsExcluded) {
  const auto outcomes = outcomes_of("CosineHemisphere", {0, 0, 1, 1});
  const ComponentOutcome cosine = named(component_outcomes(outcomes, quick), "CosineHemisphere");
  EXPECT_EQ(cosine.verdict, Verdict::certified);
  EXPECT_LT(cosine.margin, 0.01);
}

TEST(Components, NeedTwoClaimsWithEvidence) {
  auto outcomes = outcomes_of("CosineHemisphere", {6, -2, 1, 1});
  for (std::size_t i = 1; i < outcomes.size(); ++i) outcomes[i].evidence = {};
  EXPECT_TRUE(component_outcomes(outcomes, quick).empty());
}

TEST(Components, HaveATenthOfTheBudgetWhateverRuns) {
  const auto names = components_of_registry("");
  EXPECT_DOUBLE_EQ(component_level(quick) * static_cast<double>(names.size()), 1e-7);
  EXPECT_TRUE(std::ranges::find(names, "CosineHemisphere") != names.end());
}

// Only means against positive references, on both sides: for others, the sign of a bias says nothing.
TEST(Components, AddUpMeansOnly) {
  for (const Claim& claim : registry()) {
    EXPECT_FALSE(claim.adds_up && claim.kind != "mean") << claim.name;
  }
  EXPECT_FALSE(select_claims({"variance.cone_against_area"})[0]->adds_up);
  EXPECT_TRUE(select_claims({"roulette.integral"})[0]->adds_up);
}

// A common bias of half of a claim's margin, which six claims together hardly exclude, at a level of
// the grid: it is excluded with probability at most the miss rate.
TEST(Components, ExcludeABiasThatIsThereNoMoreOftenThanTheMissRate) {
  constexpr int runs = 300;
  constexpr double margin = 0.0625, bias = 0.03125, miss_rate = 0.05;
  int misses = 0;
  for (int r = 0; r < runs; ++r) {
    const Trial trial{"miss", testing::run_seed() + static_cast<std::uint64_t>(r), 1e-9, miss_rate, margin};
    const double sign = r % 2 == 0 ? 1 : -1;
    misses += simulate_component(trial, 6, margin, sign * bias).common.excluded(miss_rate) <= bias ? 1 : 0;
  }
  EXPECT_LT(misses, quantile(complement(boost::math::binomial(runs, miss_rate), 1e-8))) << misses;
}

}  // namespace
}  // namespace fairlight

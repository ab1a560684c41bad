#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <fairlight/stats/mean_test.h>

namespace fairlight {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
const Trial trial{"one_sided_test", 1, 1e-6, 0.01, 0.02};

Reference at_most(double mean) { return {.mean = mean, .lower = 0, .upper = 1, .sides = Sides::not_above}; }
Reference at_least(double mean) { return {.mean = mean, .lower = 0, .upper = 1, .sides = Sides::not_below}; }

// Zeros and ones in turn, of mean 1/2.
void in_turn(std::uint64_t first, std::vector<std::vector<double>>& channels) {
  for (auto& channel : channels) {
    for (std::size_t i = 0; i < channel.size(); ++i) channel[i] = static_cast<double>((first + i) % 2);
  }
}

TEST(OneSidedInterval, IsOpenWhereTheClaimAllowsAnyBias) {
  const Finding below = test_means(trial, {at_most(0.6)}, in_turn);
  EXPECT_EQ(below.verdict, Verdict::certified);
  EXPECT_EQ(below.interval.lo, -infinite);
  EXPECT_GT(below.interval.hi, below.bias);
  EXPECT_LT(below.interval.hi, trial.margin);
  const Finding above = test_means(trial, {at_least(0.4)}, in_turn);
  EXPECT_EQ(above.verdict, Verdict::certified);
  EXPECT_EQ(above.interval.hi, infinite);
  EXPECT_LT(above.interval.lo, above.bias);
  EXPECT_GT(above.interval.lo, -trial.margin);
}

// What is wrong is seen by the end that is past the reference.
TEST(OneSidedInterval, HasBothEndsWhereTheMeanIsOnTheWrongSide) {
  const Finding above = test_means(trial, {at_most(0.4)}, in_turn);
  EXPECT_EQ(above.verdict, Verdict::biased);
  EXPECT_GT(above.interval.lo, 0);
  EXPECT_LT(above.interval.hi, infinite);
  const Finding below = test_means(trial, {at_least(0.6)}, in_turn);
  EXPECT_EQ(below.verdict, Verdict::biased);
  EXPECT_LT(below.interval.hi, 0);
  EXPECT_GT(below.interval.lo, -infinite);
}

TEST(OneSidedInterval, HasBothEndsWhereBothSidesAreExcluded) {
  const Finding finding = test_means(trial, {{.mean = 0.5, .lower = 0, .upper = 1}}, in_turn);
  EXPECT_EQ(finding.verdict, Verdict::certified);
  EXPECT_TRUE(std::isfinite(finding.interval.lo) && std::isfinite(finding.interval.hi));
}

// The second channel is 37.5 % below what it may be, which is no fault; the first is nearer to one.
TEST(OneSidedFinding, ShowsTheChannelThatIsNearestToAFault) {
  const Finding finding = test_means(trial, {at_most(0.5), at_most(0.8)}, in_turn);
  EXPECT_EQ(finding.verdict, Verdict::certified);
  EXPECT_NEAR(finding.bias, 0, 1e-3);
  const Finding mirrored = test_means(trial, {at_least(0.5), at_least(0.2)}, in_turn);
  EXPECT_EQ(mirrored.verdict, Verdict::certified);
  EXPECT_NEAR(mirrored.bias, 0, 1e-3);
}

}  // namespace
}  // namespace fairlight

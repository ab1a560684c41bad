#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <boost/math/distributions/binomial.hpp>
#include <gtest/gtest.h>
#include <support/run_seed.h>

#include <fairlight/stats/ratio.h>

namespace fairlight {
namespace {

using Values = std::vector<double>;

// Three replicates: mean 2, deviation 1; Student's t with 2 degrees of freedom has its 97.5 %
// quantile at 4.302653.
TEST(MeasuredMean, OfThreeReplicates) {
  const auto [value, interval] = measured_mean(Values{1, 2, 3});
  EXPECT_EQ(value, 2);
  EXPECT_NEAR(interval.hi - 2, 4.302653 / std::sqrt(3), 1e-6);
  EXPECT_NEAR(2 - interval.lo, 4.302653 / std::sqrt(3), 1e-6);
}

TEST(MeasuredMean, HasAWiderIntervalAtMoreConfidence) {
  const Values values{1, 2, 3};
  EXPECT_GT(measured_mean(values, 0.99).interval.hi, measured_mean(values, 0.95).interval.hi);
}

TEST(MeasuredMean, RefusesOneReplicate) {
  EXPECT_THROW(measured_mean(Values{1}), std::invalid_argument);
  EXPECT_THROW(measured_mean(Values{1, 2}, 1), std::invalid_argument);
  EXPECT_THROW(measured_mean(Values{1, 2}, std::nan("")), std::invalid_argument);
}

TEST(MeasuredRatio, IsExactForProportionalPairs) {
  const auto [value, interval] = measured_ratio(Values{20, 22, 24}, Values{10, 11, 12});
  EXPECT_EQ(value, 2);
  EXPECT_EQ(interval.lo, 2);
  EXPECT_EQ(interval.hi, 2);
}

// With a constant denominator it is the interval of the mean, divided.
TEST(MeasuredRatio, OfAConstantDenominatorIsTheMean) {
  const Measured ratio = measured_ratio(Values{2, 4, 9}, Values{2, 2, 2}), mean = measured_mean(Values{1, 2, 4.5});
  EXPECT_NEAR(ratio.interval.lo, mean.interval.lo, 1e-12);
  EXPECT_NEAR(ratio.interval.hi, mean.interval.hi, 1e-12);
}

// The end x of the interval is where the t statistic of a - x b reaches its quantile.
TEST(MeasuredRatio, EndsWhereTheDifferenceIsSignificant) {
  const Values a{5, 7, 6, 9}, b{2, 3, 2.5, 3.1};
  const Interval interval = measured_ratio(a, b).interval;
  for (const double x : {interval.lo, interval.hi}) {
    Values difference;
    for (std::size_t i = 0; i < a.size(); ++i) difference.push_back(a[i] - x * b[i]);
    const Interval of_difference = measured_mean(difference).interval;
    EXPECT_NEAR(of_difference.lo * of_difference.hi, 0, 1e-10);
  }
}

TEST(MeasuredRatio, IsOpenWhereTheDenominatorMayBeZero) {
  const Interval interval = measured_ratio(Values{1, 2, 3}, Values{-1, 0.5, 1}).interval;
  EXPECT_EQ(interval.lo, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(interval.hi, std::numeric_limits<double>::infinity());
}

TEST(MeasuredRatio, RefusesUnpairedValues) {
  EXPECT_THROW(measured_ratio(Values{1, 2, 3}, Values{1, 2}), std::invalid_argument);
}

// Of jointly normal pairs, also correlated ones, exactly 95 % of the intervals hold the ratio. The
// limits of their number leave out 1e-7 on each side.
TEST(MeasuredRatio, CoversTheRatioOfNormalPairs) {
  std::mt19937_64 generator(testing::run_seed());
  std::normal_distribution<> normal;
  constexpr int runs = 4000;
  int covered = 0;
  for (int run = 0; run < runs; ++run) {
    Values a, b;
    for (int i = 0; i < 6; ++i) {
      const double shared = normal(generator);
      a.push_back(30 + 4 * shared + 3 * normal(generator));
      b.push_back(10 + 2 * shared);
    }
    const Interval interval = measured_ratio(a, b).interval;
    covered += interval.lo <= 3 && 3 <= interval.hi;
  }
  const boost::math::binomial law(runs, 0.95);
  EXPECT_GE(covered, quantile(law, 1e-7));
  EXPECT_LE(covered, quantile(complement(law, 1e-7)));
}

}  // namespace
}  // namespace fairlight

#include <cmath>
#include <random>
#include <stdexcept>

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <gtest/gtest.h>
#include <support/run_seed.h>

#include <fairlight/stats/welch.h>

namespace fairlight {
namespace {

// Of two samples of three draws, 1 2 3 and 2 4 6: variances of the means 1/3 and 4/3, t = 2 /
// sqrt(5/3).
const EstimatedMean small{2, 1. / 3, 2, 0}, large{4, 4. / 3, 2, 0};

TEST(Welch, IsStudentsTestOfTheSmallerDegrees) {
  const boost::math::students_t law(2);
  const double t = 2 / std::sqrt(5. / 3);
  EXPECT_NEAR(welch_p_value(small, large), 2 * cdf(complement(law, t)), 1e-12);
  EXPECT_NEAR(welch_p_value(small, {4, 4. / 3, 50, 0}), 2 * cdf(complement(law, t)), 1e-12);
  EXPECT_NEAR(welch_quantile(0.05, small, large), 4.30265, 1e-5);  // Student's tables
}

TEST(Welch, CountsOnlyTheDifferenceBeyondRounding) {
  EXPECT_EQ(welch_p_value(small, large, 2), 1);
  EXPECT_NEAR(welch_p_value(small, large, 0.5), welch_p_value(small, {3.5, 4. / 3, 2, 0}), 1e-12);
}

TEST(Welch, DecidesWhereNothingVaries) {
  EXPECT_EQ(welch_p_value({1, 0, 5, 0}, {1, 0, 5, 0}), 1);
  EXPECT_EQ(welch_p_value({1, 0, 5, 0}, {1.5, 0, 5, 0}), 0);
  EXPECT_EQ(welch_p_value({1, 0, 5, 0}, {1.5, 0, 5, 0}, 0.5), 1);
}

// 1 : 2 : the difference has variance 3, and third moments g 1 and g 2^1.5.
TEST(Welch, AddsSkewnessesAsIfTheyNeverCancelled) {
  EXPECT_NEAR(skewness_of_difference({0, 1, 9, 0.3}, {0, 2, 9, -0.3}), 0.3 * (1 + std::sqrt(8)) / std::sqrt(27),
              1e-12);
  EXPECT_EQ(skewness_of_difference({0, 0, 9, 0.3}, {0, 0, 9, 0.3}), 0);
}

TEST(Welch, ASkewLawNeedsMoreEvidence) {
  const auto p = [](double skewness) { return welch_p_value({6, 1, 200, skewness}, {0, 0, 200, 0}); };
  EXPECT_LT(p(0), 1e-7);
  EXPECT_GT(p(0.02), p(0));
  EXPECT_GT(p(0.1), p(0.02));
  EXPECT_GT(p(1), 0.1);  // one fat draw may be all there is
  EXPECT_GT(welch_quantile(0.01, {0, 1, 200, 0.1}, small), welch_quantile(0.01, {0, 1, 200, 0}, small));
}

// A deviation of 5 % has the skewness 0.15 if the law is lognormal.
TEST(Welch, OnALogarithmicScaleALognormalLawCostsNothing) {
  const EstimatedMean one{1, 0.0025, 200, 0.15}, two{2, 0.01, 200, 0.15};
  const double t = std::log(2) / std::sqrt(0.005);
  EXPECT_NEAR(welch_log_p_value(one, two), 2 * cdf(complement(boost::math::students_t(200), t)), 1e-20);
  EXPECT_GT(welch_log_p_value({1, 0.0025, 200, 0.3}, two), welch_log_p_value(one, two));
  EXPECT_GT(welch_p_value(one, two), 1e-4) << "undecided on a linear scale";
  EXPECT_EQ(welch_log_p_value({-1, 0.01, 9, 0}, two), welch_p_value({-1, 0.01, 9, 0}, two));
  EXPECT_EQ(welch_log_p_value({1, 0, 9, 0}, {1.5, 0, 9, 0}, 0.5), 1);
}

TEST(Welch, RefusesNoDegreesOfFreedom) {
  EXPECT_THROW(welch_p_value({0, 1, 0, 0}, large), std::invalid_argument);
  EXPECT_THROW(welch_quantile(0, small, large), std::invalid_argument);
  EXPECT_THROW(welch_quantile(1, small, large), std::invalid_argument);
}

EstimatedMean sample(std::mt19937_64& generator, const std::vector<double>& deviations) {
  const auto n = static_cast<double>(deviations.size());
  std::vector<double> draws;
  EstimatedMean result{0, 0, n - 1, 0};
  for (double deviation : deviations) draws.push_back(std::normal_distribution<>(0, deviation)(generator));
  for (double draw : draws) result.mean += draw / n;
  for (double draw : draws) result.squared_error += std::pow(draw - result.mean, 2) / (n * (n - 1));
  return result;
}

// The number of false alarms at `level` in 2e5 tests of equal means.
double false_alarms(double level, const std::vector<double>& a, const std::vector<double>& b) {
  std::mt19937_64 generator(testing::run_seed());
  int alarms = 0;
  for (int i = 0; i < 200000; ++i) alarms += welch_p_value(sample(generator, a), sample(generator, b)) < level;
  return alarms;
}

// At Welch's own degrees of freedom the second row raises twelve times as many as it may.
TEST(Welch, KeepsItsLevelForAnyVariances) {
  constexpr double level = 1e-3;
  const double limit = quantile(complement(boost::math::binomial(200000, level), 1e-7));
  EXPECT_LE(false_alarms(level, {1, 1, 1, 1}, {1, 1, 1, 1}), limit);
  EXPECT_LE(false_alarms(level, {1, 1, 1}, {0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3}), limit);
  EXPECT_LE(false_alarms(level, {1, 1, 1, 1}, {0.01, 0.01}), limit);
  EXPECT_LE(false_alarms(level, {1, 0.1, 0.5, 2}, {0.2, 1, 3, 0.1, 0.1}), limit) << "unequal within a sample";
}

}  // namespace
}  // namespace fairlight

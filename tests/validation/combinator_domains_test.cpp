#include <cmath>

#include <gtest/gtest.h>

#include <fairlight/stats/quadrature.h>
#include <fairlight/validation/claims/combinator_ranges.h>
#include <fairlight/validation/claims/drawn_picks.h>
#include <fairlight/validation/claims/roulette_steps.h>
#include <fairlight/validation/claims/signed_mis.h>

namespace fairlight {
namespace {

// 1 + 1/2 + 1/2 + 1/3 + 1/6 for coefficients of 1.
TEST(SignedPolynomial, HasItsIntegral) {
  const SignedPolynomial ones{{1, 1, 1, 1, 1}};
  EXPECT_DOUBLE_EQ(ones.integral(), 2.5);
  const SignedPolynomial f{{-0.5, 1.25, -2, 0.75, 3}};
  const auto value = [&](double x, double y) { return f.of<double>()({x, y}); };
  EXPECT_NEAR(integrate_rectangle(value, 0, 1, 0, 1).value, f.integral(), 1e-9);
  EXPECT_DOUBLE_EQ(value(1, 1), 2.5);
  EXPECT_DOUBLE_EQ(f.largest(), 7.5);
}

TEST(TiltedSquare, DrawsWhatItsDensitySays) {
  const TiltedSquare<double> law(0.6, -0.5);
  const auto density = [&](double x, double y) { return law.pdf({x, y}).value(); };
  EXPECT_NEAR(integrate_rectangle(density, 0, 1, 0, 1).value, 1, 1e-9);
  EXPECT_DOUBLE_EQ(density(0, 1), 0.4 * 0.5);
  EXPECT_DOUBLE_EQ(TiltedSquare<double>::least(0.6, -0.5), 0.2);
  // The part below x is s x^2 + (1 - s) x.
  for (const double u : {0.0, 0.3, 0.9}) {
    const Vec2<double> p = law.sample({u, u});
    EXPECT_NEAR(0.6 * p.x() * p.x() + 0.4 * p.x(), u, 1e-15);
    EXPECT_NEAR(-0.5 * p.y() * p.y() + 1.5 * p.y(), u, 1e-15);
  }
}

TEST(LeftPart, HasNoDensityBeyondItsWidth) {
  const LeftPart<double> law(0.25);
  EXPECT_EQ(law.pdf(Vec2<double>(0.2, 0.5)).value(), 4);
  EXPECT_EQ(law.pdf(Vec2<double>(0.3, 0.5)).value(), 0);
  const Vec2<double> drawn = law.sample({0.5, 0.75});
  EXPECT_EQ(drawn.x(), 0.125);
  EXPECT_EQ(drawn.y(), 0.75);
}

TEST(PolynomialRanges, HaveOnePolynomialOfEachSign) {
  const std::vector<ParameterRange> ranges = polynomial_ranges("Importance", 3);
  ASSERT_EQ(ranges.size(), 17u);
  std::vector<double> low, high;
  for (const ParameterRange& range : ranges) {
    low.push_back(range.low);
    high.push_back(range.high);
  }
  DrawnValues next_low(low), next_high(high);
  const TiltedPolynomials<3> least(next_low), most(next_high);
  EXPECT_LT(most.polynomials[0].integral(), 0);
  EXPECT_GT(least.polynomials[2].integral(), 0);
}

// No weight, a tie, and a last term that is a twentieth of the sum.
TEST(WeighedTerms, HaveTiesAndTermsWithoutWeight) {
  const WeighedTerms list(17, 0.25, 0.75);
  EXPECT_EQ(list.weights[3], 0);
  EXPECT_EQ(list.terms[3], 0);
  EXPECT_EQ(list.weights[5], list.weights[4]);
  EXPECT_NEAR(list.weights.back() / list.sum_of_weights(), 0.05 / 1.05, 1e-12);
  EXPECT_LT(*std::min_element(list.terms.begin(), list.terms.end()), 0);
  EXPECT_GT(*std::max_element(list.terms.begin(), list.terms.end()), 0);
  EXPECT_EQ(WeighedTerms(1, 0.25, 0.75).terms.size(), 1u);
}

TEST(WeighedTerms, AreOneBrightAndManyFaint) {
  const WeighedTerms list = WeighedTerms::very_unequal(3, 0.5);
  const std::vector<double> weights{1, 1e-6, 1e-6, 1e-6};
  EXPECT_EQ(list.weights, weights);
  EXPECT_DOUBLE_EQ(list.sum(), 1 + 1.0 / 3);
  EXPECT_DOUBLE_EQ(list.sum_of_sizes(), 2);
  EXPECT_NEAR(list.largest_by_weight(), 1e6 / 3 * 1.000003, 1e-3);
  EXPECT_DOUBLE_EQ(list.largest_of_n(), 4);
}

// An albedo of (0.2, 0.5, 0.8) and a throughput of 2: the reflectance survives with 0.8, the throughput with 1.
TEST(RouletteSteps, HaveTheRangeOfTheirSurvivors) {
  std::vector<double> values;
  for (int step = 0; step < 3; ++step) {
    for (const double x : {0.2, 0.5, 0.8, 2.0, 2.0, 2.0, 1.0}) values.push_back(x);
  }
  const auto by_reflectance = steps_by_reflectance<RouletteByReflectance<>>(values).references;
  ASSERT_EQ(by_reflectance.size(), 9u);
  EXPECT_DOUBLE_EQ(by_reflectance[1].mean, 1);
  EXPECT_NEAR(by_reflectance[1].upper, 1 / 0.8, 1e-9);
  EXPECT_NEAR(steps_by_throughput<RouletteByThroughput<>>(values).references[1].upper, 1, 1e-9);
  EXPECT_NEAR(steps_from_fourth_bounce<RouletteByReflectance<>>(values).references[1].upper, 1, 1e-9);
}

}  // namespace
}  // namespace fairlight

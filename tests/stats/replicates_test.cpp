#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include <fairlight/stats/replicates.h>

namespace fairlight {
namespace {

const Trial trial{"replicates", 1, 1e-6, 0.01, 0.05};

double alternating(std::uint64_t r) { return r % 2 == 0 ? 0.9 : 1.1; }

TEST(Replicates, AreTheDraws) {
  EXPECT_EQ(test_replicates(trial, Reference{1, 0, 2}, alternating).verdict, Verdict::certified);
  EXPECT_EQ(test_replicates(trial, Reference{1.2, 0, 2.5}, alternating).verdict, Verdict::biased);
  EXPECT_EQ(test_replicates(trial, 1.0, alternating).verdict, Verdict::certified);
  EXPECT_EQ(test_replicates(trial, 1.2, alternating).verdict, Verdict::biased);
}

TEST(ConvergenceExponent, IsTheSlopeOnLogarithms) {
  const std::vector<std::pair<double, double>> cubic{{10, 1e-3}, {100, 1e-6}, {1000, 1e-9}};
  EXPECT_NEAR(convergence_exponent(cubic), 3, 1e-12);
  const std::vector<std::pair<double, double>> one{{10, 1}};
  EXPECT_THROW(convergence_exponent(one), std::invalid_argument);
  const std::vector<std::pair<double, double>> none{{10, 1}, {20, 0}};
  EXPECT_THROW(convergence_exponent(none), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

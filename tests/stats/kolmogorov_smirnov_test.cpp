#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <fairlight/stats/kolmogorov_smirnov.h>

namespace fairlight {
namespace {

std::vector<double> grid(int n) {
  std::vector<double> numbers;
  for (int i = 0; i < n; ++i) numbers.push_back((i + 0.5) / n);
  return numbers;
}

TEST(KolmogorovSmirnov, IsTheLargestDistanceFromTheDiagonal) {
  std::vector<double> numbers{0.9, 0.1, 0.2};
  EXPECT_DOUBLE_EQ(kolmogorov_smirnov(numbers).distance, 2.0 / 3 - 0.2);
}

TEST(KolmogorovSmirnov, FindsASquareRootTooFar) {
  std::vector<double> numbers = grid(1000);
  for (double& x : numbers) x = std::sqrt(x);  // distribution function x^2, farthest at 1/2: 1/4
  const auto result = kolmogorov_smirnov(numbers);
  EXPECT_NEAR(result.distance, 0.25, 1e-3);
  EXPECT_EQ(result.too_near, 1);
  EXPECT_NEAR(std::log(result.too_far), std::log(2) - 2 * 1000 * result.distance * result.distance, 1e-9);
}

TEST(KolmogorovSmirnov, FindsAGridTooNear) {
  std::vector<double> numbers = grid(1000);
  EXPECT_LT(kolmogorov_smirnov(numbers).too_near, 1e-100);
}

// The median of the limiting law is 0.82757 (Smirnov's table).
TEST(KolmogorovSmirnov, HasTheMedianOfTheTable) {
  constexpr int n = 1'000'000;
  std::vector<double> numbers = grid(n);
  for (double& x : numbers) x *= 1 - 0.82757e-3;
  EXPECT_NEAR(kolmogorov_smirnov(numbers).too_near, 0.5, 2e-3);
}

TEST(KolmogorovSmirnov, RefusesNoNumbersAndNumbersOutsideTheUnitInterval) {
  std::vector<double> none;
  std::vector<double> outside{0.5, 1.5};
  std::vector<double> nan{0.2, std::nan(""), 0.3};
  EXPECT_THROW(kolmogorov_smirnov(none), std::invalid_argument);
  EXPECT_THROW(kolmogorov_smirnov(outside), std::invalid_argument);
  EXPECT_THROW(kolmogorov_smirnov(nan), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

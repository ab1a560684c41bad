#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/unit_square.h>

#include <fairlight/validation/claims/geometric_sum.h>

namespace fairlight {
namespace {

// A law of terms 0, 1, 2, 3 and 4, whose weights need not add up to one.
using Law = std::array<double, 5>;

// E[(sum - b)+] = E[sum] - E[min(sum, b)], a number of terms being summed that go on with q: P(sum = j) by what the first term is.
double beyond(Law law, double q, int b) {
  double total = 0, mean = 0;
  for (double weight : law) total += weight;
  for (std::size_t i = 0; i < law.size(); ++i) mean += static_cast<double>(i) * (law[i] /= total);
  double least = b;
  std::vector<double> sum;
  for (std::size_t j = 0; j < static_cast<std::size_t>(b); ++j) {
    double p = j < law.size() ? (1 - q) * law[j] : 0;
    for (std::size_t i = 1; i < law.size() && i <= j; ++i) p += q * law[i] * sum[j - i];
    sum.push_back(p / (1 - q * law[0]));
    least -= (b - static_cast<double>(j)) * sum.back();
  }
  return mean / (1 - q) - least;
}

double mean_of(const Law& law) {
  double total = 0, mean = 0;
  for (std::size_t i = 0; i < law.size(); ++i) {
    total += law[i];
    mean += static_cast<double>(i) * law[i];
  }
  return mean / total;
}

// Down to what rounding leaves of the difference above.
TEST(GeometricSum, IsBeyondItsBoundByNoMoreThanTheSlackWhateverTheLaw) {
  EXPECT_TRUE(rc::check([] {
    Law law;
    for (double& weight : law) weight = 0.01 + *testing::unit_number();
    const double q = 0.05 + 0.9 * *testing::unit_number();
    const double slack = std::exp(-2 - 15 * *testing::unit_number());
    const auto bound = static_cast<int>(GeometricSum{mean_of(law), 4, q}.bound(slack));
    RC_ASSERT(beyond(law, q, bound) <= slack + 1e-11);
  }));
}

TEST(GeometricSum, HasTheLeastMultipleForTermsOfNothingOrTheLargest) {
  EXPECT_TRUE(rc::check([] {
    const Law law{0.01 + *testing::unit_number(), 0, 0, 0, 0.01 + *testing::unit_number()};
    const double q = 0.05 + 0.9 * *testing::unit_number();
    const double slack = std::exp(-2 - 15 * *testing::unit_number());
    const auto bound = static_cast<int>(GeometricSum{mean_of(law), 4, q}.bound(slack));
    RC_PRE(bound > 0);
    RC_ASSERT(beyond(law, q, bound) <= slack + 1e-11);
    RC_ASSERT(beyond(law, q, bound - 4) > slack - 1e-11);
  }));
}

// A geometric number of vertices that bring 1 each: q^m / (1 - q) is beyond m of them.
TEST(GeometricSum, CountsVertices) {
  EXPECT_EQ((GeometricSum{1, 1, 0.5}.bound(0.25)), 3);
  EXPECT_EQ((GeometricSum{1, 1, 0.5}.bound(0.2)), 4);
  EXPECT_EQ((GeometricSum{1, 1, 0.5}.bound(3)), 0);
}

TEST(GeometricSum, RefusesWhatIsOutsideOfItsDomain) {
  EXPECT_THROW((GeometricSum{0, 1, 0.5}.bound(1e-9)), std::invalid_argument);
  EXPECT_THROW((GeometricSum{2, 1, 0.5}.bound(1e-9)), std::invalid_argument);
  EXPECT_THROW((GeometricSum{1, 1, 1}.bound(1e-9)), std::invalid_argument);
  EXPECT_THROW((GeometricSum{1, 1, 0.5}.bound(0)), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

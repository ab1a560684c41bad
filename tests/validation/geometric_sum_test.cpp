#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/unit_square.h>

#include <fairlight/validation/analytic/geometric_sum.h>

namespace fairlight {
namespace {

// Terms of 0 and `largest` alone, which reach the furthest: C of them are large, where P(C >= 1) = a = p / (1 - q (1 - p)), and once there
// was one there is another with q a. Beyond m of them E[(sum - m largest)+] is largest a (q a)^m / (1 - q a).
double beyond(const GeometricSum& sum, double count) {
  const double p = sum.mean / sum.largest, q = sum.goes_on;
  const double a = p / (1 - q * (1 - p));
  return sum.largest * a * std::pow(q * a, count) / (1 - q * a);
}

TEST(GeometricSum, IsBeyondItsBoundByNoMoreThanTheSlack) {
  EXPECT_TRUE(rc::check([] {
    const double largest = 0.1 + 50 * *testing::unit_number();
    const GeometricSum sum{largest * (0.01 + 0.99 * *testing::unit_number()), largest,
                           0.05 + 0.9 * *testing::unit_number()};
    const double slack = largest * std::exp(-5 - 20 * *testing::unit_number());
    RC_ASSERT(beyond(sum, std::ceil(sum.bound(slack) / largest)) <= slack);
  }));
}

// The geometric law itself: of as many vertices, q^m / (1 - q) is beyond m.
TEST(GeometricSum, IsNotFarFromTheLeastBound) {
  const GeometricSum vertices{1, 1, 0.7};
  const double slack = std::pow(0.7, 60) / 0.3;
  EXPECT_GT(vertices.bound(slack), 60);
  EXPECT_LT(vertices.bound(slack), 72);
}

TEST(GeometricSum, RefusesWhatIsOutsideOfItsDomain) {
  EXPECT_THROW((GeometricSum{0, 1, 0.5}.bound(1e-9)), std::invalid_argument);
  EXPECT_THROW((GeometricSum{2, 1, 0.5}.bound(1e-9)), std::invalid_argument);
  EXPECT_THROW((GeometricSum{1, 1, 1}.bound(1e-9)), std::invalid_argument);
  EXPECT_THROW((GeometricSum{1, 1, 0.5}.bound(0)), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/estimators/inversion.h>

namespace fairlight::detail {
namespace {

// For x^2 - 2 a step leads from x to x (x^2 + 6) / (3 x^2 + 2): from 3/2 to 99/70, which is 7e-5
// above the root.
TEST(HalleyStep, OfASquareRoot) {
  EXPECT_DOUBLE_EQ(halley_step(1.5, 0.25, 3.0, 2.0, 1.0, 2.0), 99.0 / 70);
  EXPECT_DOUBLE_EQ(halley_step(1.0, -1.0, 2.0, 2.0, 0.0, 2.0), 7.0 / 5);
}

TEST(HalleyStep, GoesHalfWayToAnEndThatItWouldPass) {
  EXPECT_DOUBLE_EQ(halley_step(1.5, 0.25, 3.0, 2.0, 1.45, 2.0), 1.475);
  EXPECT_DOUBLE_EQ(halley_step(1.0, -1.0, 2.0, 2.0, 0.0, 1.2), 1.1);
}

// To the 4e-7 of the source, on both sides of the switch between the polynomials, and up to q =
// 1e-7.
RC_GTEST_PROP(RoughInverseErf, IsRightToSixDigits, ()) {
  const double y = *rc::gen::inRange(1, 3766) * 1e-3;
  RC_ASSERT(std::abs(rough_inverse_erf(std::erf(y), std::erfc(y)) / y - 1) < 5e-7);
}

}  // namespace
}  // namespace fairlight::detail

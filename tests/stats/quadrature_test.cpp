#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <fairlight/stats/quadrature.h>

namespace fairlight {
namespace {

TEST(IntegrateRectangle, OfAPolynomialIsExact) {
  const Integral integral = integrate_rectangle([](double x, double y) { return x * y * y; }, 0, 2, 1, 4);
  EXPECT_NEAR(integral.value, 2 * 21, 1e-12);
}

TEST(IntegrateRectangle, CarriesItsError) {
  const auto kink = [](double x, double y) { return std::abs(x - 1 / std::numbers::pi) + y; };
  const Integral integral = integrate_rectangle(kink, 0, 1, 0, 1);
  const double a = 1 / std::numbers::pi;
  const double exact = (a * a + (1 - a) * (1 - a)) / 2 + 0.5;
  EXPECT_LE(std::abs(integral.value - exact), integral.error + 1e-12);
  EXPECT_LT(integral.error, 1e-5);
}

}  // namespace
}  // namespace fairlight

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <fairlight/stats/quadrature.h>
#include <fairlight/validation/claims/rendered_variance.h>
#include <fairlight/validation/claims/signed_integrals.h>

namespace fairlight {
namespace {

TEST(SignedIntegrand, HasTheIntegralOfItsEvenPart) {
  const SignedIntegrand f{1.5, -2, 0.5};
  const auto integrand = [&](double z, double phi) {
    const double r = std::sqrt(1 - z * z);
    return f.of<double>()({r * std::cos(phi), r * std::sin(phi), z});
  };
  const double integral = integrate_rectangle(integrand, 0, 1, 0, 2 * std::numbers::pi).value;
  EXPECT_NEAR(integral, f.integral(), 1e-6);
  EXPECT_DOUBLE_EQ(f.integral(), std::numbers::pi / 2);
  // Its extremes are beyond c and -c: along (a, b) and against it, 0.5 + 2.5 and 0.5 - 2.5, times z.
  EXPECT_DOUBLE_EQ(f.bound(1).upper, 3);
  EXPECT_DOUBLE_EQ(f.bound(1).lower, -3);
  EXPECT_LT(f.of<double>()({-0.36, 0.48, 0.8}), 0);
}

// The camera is 0.2 m before a ball of radius 1 m, which its picture lies wholly in: each ray from it hits the ball.
TEST(GreyBall, FillsItsPicture) {
  const View view = grey_ball().view;
  for (const double x : {0.0, 0.5, 1.0}) {
    for (const double y : {0.0, 0.5, 1.0}) {
      const Ray<double> ray = view.camera.ray<double>(x, y, 1, 1);
      const double across = ray.origin.cross(ray.direction).norm() / ray.direction.norm();
      EXPECT_LT(across, 1) << x << ' ' << y;
    }
  }
}

}  // namespace
}  // namespace fairlight

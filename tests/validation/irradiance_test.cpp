#include <cmath>

#include <gtest/gtest.h>

#include <fairlight/stats/quadrature.h>
#include <fairlight/validation/claims/irradiance.h>

namespace fairlight {
namespace {

// The closed forms that claims rest on, against quadrature over what they are integrals of.

// Over the cone, in polar coordinates about its axis; the horizon makes a kink in the integrand, so 1e-6.
double cone_by_quadrature(double r, double d, double cosine) {
  const double a = std::asin(r / d);
  const double sine = std::sqrt(1 - cosine * cosine);
  const auto lit = [&](double theta, double phi) {
    const double z = std::cos(theta) * cosine + std::sin(theta) * std::cos(phi) * sine;
    return std::max(z, 0.0) * std::sin(theta);
  };
  return 2 * integrate_rectangle(lit, 0, a, 0, M_PI).value;
}

TEST(SphereIrradiance, IsThatOfItsCone) {
  for (double cosine : {1.0, 0.6, 0.3, 0.0, -0.3, -0.6}) {
    EXPECT_NEAR(sphere_irradiance(2, 4, cosine), cone_by_quadrature(2, 4, cosine), 1e-6) << cosine;
  }
}

// Half of a sphere whose centre is on the horizon, at right angles to the normal, of half-angle near pi/2: half a hemisphere.
TEST(SphereIrradiance, IsHalfAHemisphereOnTheHorizon) {
  EXPECT_NEAR(sphere_irradiance(1, 1 + 1e-9, 0), M_PI / 2, 1e-3);
}

TEST(PolygonIrradiance, IsTheIntegralOverARectangle) {
  const std::vector<Eigen::Vector3d> corners{{0.5, -0.5, 2}, {2, -0.5, 2}, {2, 1, 2}, {0.5, 1, 2}};
  for (const Eigen::Vector3d& normal : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 0, 0)}) {
    const auto lit = [&](double x, double y) {
      const Eigen::Vector3d way(x, y, 2);
      return normal.dot(way) * 2 / (way.squaredNorm() * way.squaredNorm());
    };
    const double expected = integrate_rectangle(lit, 0.5, 2, -0.5, 1).value;
    EXPECT_NEAR(polygon_irradiance(corners, normal), expected, 1e-9);
  }
}

TEST(RectangleSolidAngle, IsASixthOfAllDirectionsForTheFaceOfACube) {
  EXPECT_NEAR(rectangle_solid_angle(-1, 1, -1, 1, 1), 4 * M_PI / 6, 1e-15);
}

}  // namespace
}  // namespace fairlight

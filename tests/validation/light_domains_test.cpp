#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <fairlight/stats/quadrature.h>
#include <fairlight/validation/claims/lights_at_any_distance.h>

namespace fairlight {
namespace {

constexpr double pi_ = std::numbers::pi;

// A square overhead, of which the horizon of a normal along x leaves the half with x > 0.
TEST(AboveHorizon, CutsASquareInTwo) {
  const std::vector<Eigen::Vector3d> square{{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}};
  const auto kept = above_horizon(square, {1, 0, 0});
  ASSERT_EQ(kept.size(), 4u);
  for (const Eigen::Vector3d& corner : kept) EXPECT_TRUE(corner.x() == 0 || corner.x() == 1) << corner.transpose();
  EXPECT_EQ(above_horizon(square, {0, 0, 1}), square);
  EXPECT_TRUE(above_horizon(square, {0, 0, -1}).empty());
  EXPECT_EQ(polygon_irradiance({}, {0, 0, 1}), 0);
}

// The values of a rectangle of 2 x 1 at the distance 1, whose centre is head-on from both sides.
std::vector<double> head_on() { return {1, 2, 0.5, 0, 1, 0, 1, 0, 1, 0, 0, 0.25, -0.5, 0.125}; }

TEST(PlacedRectangle, IsWhereItsValuesSay) {
  const std::vector<double> values = head_on();
  DrawnValues next(values);
  const PlacedRectangle placed = placed_rectangle(next);
  EXPECT_TRUE(placed.point.isApprox(Vec3<double>(0.25, -0.5, 0.125)));
  EXPECT_TRUE(placed.normal.isApprox(Vec3<double>(0, 0, 1)));
  EXPECT_DOUBLE_EQ(placed.edge_x.norm(), 2);
  EXPECT_DOUBLE_EQ(placed.edge_y.norm(), 1);
  EXPECT_DOUBLE_EQ(placed.corner_in_axes().z(), 1);
  EXPECT_DOUBLE_EQ(placed.solid_angle(), rectangle_solid_angle(-1, 1, -0.5, 0.5, 1));
  EXPECT_DOUBLE_EQ(placed.area_bound(), 2);
}

// Over its own surface: cos_S cos_L / t^2, where cos_S > 0. The horizon makes a kink, so 1e-6.
TEST(PlacedRectangle, HasTheIrradianceOfAnIntegralOverIt) {
  for (const double at_light : {0.5, -0.3}) {
    std::vector<double> values = head_on();
    values[4] = at_light;
    values[6] = 0.3;
    values[7] = 2;
    values[8] = 0.4;
    DrawnValues next(values);
    const PlacedRectangle placed = placed_rectangle(next);
    const Vec3<double> across = placed.edge_x.cross(placed.edge_y).normalized();
    const auto lit = [&](double u, double v) {
      const Vec3<double> way = placed.corner + u * placed.edge_x + v * placed.edge_y - placed.point;
      const double t = way.norm();
      return std::max(0.0, placed.normal.dot(way)) * std::abs(across.dot(way)) * 2 / (t * t * t * t);
    };
    EXPECT_NEAR(placed.irradiance(), integrate_rectangle(lit, 0, 1, 0, 1).value, 1e-6);
    EXPECT_EQ(placed.corner_in_axes().z() > 0, at_light > 0);
  }
}

// A plane without end fills half of all directions; a surface at the angle t to it sees (1 + cos t) / 2 of pi.
TEST(PlacedNearPlanes, AreNearlyWithoutEnd) {
  std::vector<double> values;
  for (int c = 0; c < 3; ++c) {
    for (const double x : {1.0, 1e6, 1.0, 0.5, 0.5, 0.6, 1.0}) values.push_back(x);
  }
  for (const PlacedRectangle& plane : placed_near_planes(values)) EXPECT_NEAR(plane.irradiance(), pi_ * 0.8, 1e-5);
}

PlacedSphere sphere(const std::vector<double>& values, PlaceAtSphere place) {
  DrawnValues next(values);
  return placed_sphere(next, place);
}

TEST(PlacedSphere, IsOutsideAroundOrBesideThePoint) {
  // Distance 2, radius 1, overhead; cosine at the surface 0.8.
  const std::vector<double> values{2, 0.5, 1, 0, 0.8, 0, 0, 0, 0};
  EXPECT_NEAR(sphere(values, PlaceAtSphere::outside).irradiance(), pi_ * 0.25 * 0.8, 1e-12);
  // In units of the sine of the cone, 1/2: the cosine 0.4.
  EXPECT_NEAR(sphere(values, PlaceAtSphere::cut).normal.z(), 0.4, 1e-12);
  EXPECT_NEAR(sphere({2, 4, 1, 0, 0.8, 0, 0, 0, 0}, PlaceAtSphere::inside).irradiance(), pi_, 1e-12);
  EXPECT_NEAR(sphere({2, 1, 1, 0, 0.8, 0, 0, 0, 0}, PlaceAtSphere::on_it).irradiance(), pi_ * 0.9, 1e-12);
  EXPECT_EQ(bound_of(sphere({2, 4, 1, 0, 0.8, 0, 0, 0, 0}, PlaceAtSphere::inside), BoundOfLight::solid_angle),
            4 * pi_);
}

// The factor of a draw is 1 for a point of the light, and another number elsewhere.
TEST(PlacedLights, KnowWhetherASampleIsOnThem) {
  const auto ahead = [](double distance) {
    return LightSample<double>{{0, 0, 1}, distance, Density<SolidAngle, double>(1)};
  };
  const std::vector<double> values = head_on();
  DrawnValues next(values);
  const PlacedRectangle rectangle = placed_rectangle(next);
  EXPECT_DOUBLE_EQ(rectangle.on_light(ahead(1)), 1);
  EXPECT_DOUBLE_EQ(rectangle.on_light(ahead(1.5)), 1.5);
  const PlacedSphere ball = sphere({2, 0.5, 1, 0, 0.8, 0, 0, 0, 0}, PlaceAtSphere::outside);
  EXPECT_DOUBLE_EQ(ball.on_light(ahead(1)), 1);
  EXPECT_DOUBLE_EQ(ball.on_light(ahead(2)), 0);
}

}  // namespace
}  // namespace fairlight

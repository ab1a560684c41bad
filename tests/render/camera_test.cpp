#include <array>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/scripted_source.h>
#include <support/unit_square.h>

#include <fairlight/estimators/filter.h>
#include <fairlight/render/camera.h>

namespace fairlight {
namespace {

// At the origin, looking along -z, an image plane 2 high at distance 1.
Camera simple(double start = 0) { return Camera({.image_height = 2, .start = start}); }

TEST(Camera, LooksThroughTheMiddleOfTheImage) {
  const Ray<double> ray = simple().ray(8.0, 4.0, 16, 8);
  EXPECT_TRUE(ray.direction.isApprox(Vec3<double>(0, 0, -1)));
  EXPECT_EQ(ray.origin_primitive, -1);
}

TEST(Camera, HasItsFirstPixelAtTheTopLeft) {
  const Ray<double> ray = simple().ray(0.0, 0.0, 8, 8);
  EXPECT_TRUE(ray.direction.isApprox(Vec3<double>(-1, 1, -1).normalized()));
}

TEST(Camera, HasSquarePixelsInAWideImage) {
  const Ray<double> ray = simple().ray(16.0, 8.0, 16, 8);
  EXPECT_TRUE(ray.direction.isApprox(Vec3<double>(2, -1, -1).normalized()));
}

TEST(Camera, StartsRaysOnAPlaneAcrossTheAxis) {
  const Ray<double> ray = simple(3).ray(0.0, 0.0, 8, 8);
  EXPECT_TRUE(ray.origin.isApprox(Vec3<double>(-3, 3, -3)));
}

TEST(Camera, TurnsAboutItsAxis) {
  const Camera sideways({.up = {5, 0, 0}, .image_height = 2});
  EXPECT_TRUE(sideways.ray(4.0, 0.0, 8, 8).direction.isApprox(Vec3<double>(1, 0, -1).normalized()));
}

TEST(Camera, HasTheFieldOfViewThatItIsGiven) {
  EXPECT_NEAR(image_height_of(90), 2, 1e-15);
  const Camera camera({.image_height = image_height_of(60)});
  const double top = -camera.ray(4.0, 0.0, 8, 8).direction.dot(Vec3<double>(0, 0, 1));
  EXPECT_NEAR(std::acos(top), M_PI / 6, 1e-15);
}

TEST(Camera, TakesNoNumbersForAPinhole) {
  testing::ScriptedSource none({});
  const Ray<double> ray = simple(3).ray(1.0, 2.0, 8, 8, none);
  EXPECT_EQ(ray.direction, simple(3).ray(1.0, 2.0, 8, 8).direction);
  EXPECT_EQ(ray.origin, simple(3).ray(1.0, 2.0, 8, 8).origin);
}

TEST(Camera, PutsThePixelsMiddleWhereItsFilterIs) {
  testing::ScriptedSource middle({0.5, 0.5});
  const Ray<double> ray = pixel_ray(simple(), TentFilter<double>(), 3, 1, 8, 8, middle);
  EXPECT_TRUE(ray.direction.isApprox(simple().ray(3.5, 1.5, 8, 8).direction));
  EXPECT_TRUE(middle.exhausted());
}

// A lens of radius 2 focused at distance 4: the point (1, 0) of it, to the right.
TEST(Camera, BendsRaysOfALensToThePointInFocus) {
  const Camera lens({.image_height = 2, .aperture_radius = 2, .focus_distance = 4});
  testing::ScriptedSource numbers({0.75, 0.5});
  const Ray<double> ray = lens.ray(0.0, 0.0, 8, 8, numbers);
  EXPECT_TRUE(ray.origin.isApprox(Vec3<double>(1, 0, 0)));
  EXPECT_TRUE(ray.direction.isApprox(Vec3<double>(-4 - 1, 4, -4).normalized()));
  EXPECT_TRUE(numbers.exhausted());
}

Vec3<double> where_it_crosses(const Ray<double>& ray, const CameraSettings& s, double distance) {
  const Vec3<double> axis = s.look.normalized();
  return ray.origin + ray.direction * ((distance - (ray.origin - s.eye).dot(axis)) / ray.direction.dot(axis));
}

// Whatever the lens, its place, and where its rays start: they meet the pinhole's ray in the plane in focus, and come
// through the lens.
RC_GTEST_PROP(Camera, MeetsThePinholesRayInFocus, ()) {
  const auto length = [] { return std::exp(std::log(1e-2) + std::log(1e4) * *testing::unit_number()); };
  const CameraSettings settings{.eye = {5, -3, 2},
                                .look = {1, 0.5, -2},
                                .image_height = image_height_of(1 + 170 * *testing::unit_number()),
                                .start = *testing::unit_number(),
                                .aperture_radius = length(),
                                .focus_distance = length(),
                                .blades = *rc::gen::element(0, 3, 5, 8),
                                .blade_rotation = 6 * *testing::unit_number()};
  const Camera camera(settings);
  const double x = 16 * *testing::unit_number();
  const double y = 8 * *testing::unit_number();
  testing::ScriptedSource numbers({*testing::unit_number(), *testing::unit_number()});
  const Ray<double> ray = camera.ray(x, y, 16, 8, numbers);
  RC_ASSERT(std::abs(ray.direction.norm() - 1) < 1e-15);
  const Vec3<double> crossing = where_it_crosses(ray, settings, settings.focus_distance);
  const Vec3<double> pinhole = where_it_crosses(camera.ray(x, y, 16, 8), settings, settings.focus_distance);
  // Where the ray starts far beyond the focus, it is traced back, and its rounding grows with the distance.
  const double scale = settings.aperture_radius + (pinhole - settings.eye).norm() +
                       (1 + settings.start / settings.focus_distance) * (settings.eye.norm() + ray.origin.norm());
  // What a rounded direction is worth: a ray from the rim of a lens that is wide for its focus hardly goes along the axis.
  const double grazing = 1 + (settings.aperture_radius + (pinhole - settings.eye).norm()) / settings.focus_distance;
  const double rounding = 64 * ulp<double> * scale * grazing * (1 + settings.start);
  RC_ASSERT((crossing - pinhole).norm() <= rounding);
  const Vec3<double> on_lens = where_it_crosses(ray, settings, 0) - settings.eye;
  RC_ASSERT(on_lens.norm() <= settings.aperture_radius + rounding);
}

TEST(Camera, IsTheSameInPackets) {
  const Camera camera({.eye = {5, -3, 2},
                       .look = {1, 0.5, -2},
                       .image_height = 2,
                       .start = 1,
                       .aperture_radius = 0.25,
                       .focus_distance = 4,
                       .blades = 6});
  struct {
    Packet next() { return Packet(0.7f); }
  } packets;
  testing::ScriptedSource numbers({0.7, 0.7});
  const Ray<Packet> ray = camera.ray(Packet(3), Packet(5), 16, 8, packets);
  const Ray<double> expected = camera.ray(3.0, 5.0, 16, 8, numbers);
  for (int axis = 0; axis < 3; ++axis) {
    std::array<double, lanes<Packet>> origin{}, direction{};
    store_lanes(ray.origin[axis], origin.data());
    store_lanes(ray.direction[axis], direction.data());
    for (std::size_t k = 0; k < origin.size(); ++k) {
      EXPECT_NEAR(origin[k], expected.origin[axis], 1e-5);
      EXPECT_NEAR(direction[k], expected.direction[axis], 1e-6);
    }
  }
}

TEST(Camera, RefusesWhatHasNoPicture) {
  const auto refused = [](const CameraSettings& settings) {
    EXPECT_THROW(Camera{settings}, std::invalid_argument);
  };
  refused({.look = {0, 1, 0}});
  refused({.look = {0, 0, 0}});
  refused({.up = {0, 0, 3}});
  refused({.up = {0, 0, 0}});
  refused({.eye = {0, std::nan(""), 0}});
  refused({.image_height = 0});
  refused({.image_height = infinity<double>});
  refused({.start = -1});
  refused({.aperture_radius = -1});
  refused({.aperture_radius = std::nan("")});
  refused({.aperture_radius = infinity<double>});
  refused({.focus_distance = 0});
  refused({.focus_distance = std::nan("")});
  refused({.blades = -1});
  refused({.blades = 2});
  refused({.blades = 5, .blade_rotation = std::nan("")});
  refused({.blades = 5, .blade_rotation = infinity<double>});
  EXPECT_THROW(image_height_of(0), std::invalid_argument);
  EXPECT_THROW(image_height_of(180), std::invalid_argument);
  EXPECT_THROW(image_height_of(std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

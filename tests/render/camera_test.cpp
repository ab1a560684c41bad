#include <stdexcept>

#include <gtest/gtest.h>

#include <fairlight/render/camera.h>

namespace fairlight {
namespace {

// At the origin, looking along -z, an image plane 2 high at distance 1.
Camera simple(double start = 0) { return Camera({0, 0, 0}, {0, 0, -1}, 2, start); }

TEST(Camera, LooksThroughTheMiddleOfTheImage) {
  const Ray<double> ray = simple().ray(8.0, 4.0, 16, 8);
  EXPECT_TRUE(ray.direction.isApprox(Vec3<double>(0, 0, -1)));
  EXPECT_EQ(ray.leaving, -1);
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

TEST(Camera, RefusesWhatHasNoPicture) {
  EXPECT_THROW(Camera({0, 0, 0}, {0, 1, 0}, 2, 0), std::invalid_argument);
  EXPECT_THROW(Camera({0, 0, 0}, {0, 0, 0}, 2, 0), std::invalid_argument);
  EXPECT_THROW(Camera({0, 0, 0}, {0, 0, -1}, 0, 0), std::invalid_argument);
  EXPECT_THROW(Camera({0, 0, 0}, {0, 0, -1}, 2, -1), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

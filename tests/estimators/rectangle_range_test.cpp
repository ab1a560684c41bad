#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/unit_square.h>

#include <fairlight/estimators/rectangle_light.h>

// Rectangles at the limits of floats: sides and distances from 1e-10 to 1e10 m, planes as near as
// 1e-15 of the other coordinates.
namespace fairlight {
namespace {

constexpr double rounding = 32 * 0x1p-23;  // about thirty operations, as in lights_of_any_size_test.cpp

// A rectangle of the given sides, centred at (0, 0, z).
RectangleLight<float> above(double width, double height, double z) {
  return {Vec3<double>(-width / 2, -height / 2, z).cast<float>(), Vec3<double>(width, 0, 0).cast<float>(),
          Vec3<double>(0, height, 0).cast<float>()};
}

double solid_angle(const RectangleLight<float>& light) {
  const auto density = RectangleBySolidAngle<float>(light).sample({0, 0, 0}, {0.5f, 0.5f}).density;
  return 1 / static_cast<double>(density.value());
}

// From a point close to its middle a rectangle fills half of all directions; from far away, its
// area over the squared distance.
TEST(RectangleBySolidAngle, FillsHalfOfAllFromNearAndLittleFromFar) {
  for (double ratio : {1e-8, 1e-11, 1e-14}) {
    EXPECT_NEAR(solid_angle(above(1, 1, ratio)) / (2 * M_PI), 1, rounding) << ratio;
    EXPECT_NEAR(solid_angle(above(1e5, 1e5, 1e5 * ratio)) / (2 * M_PI), 1, rounding) << ratio;
    EXPECT_NEAR(solid_angle(above(ratio * 1e5, ratio * 1e5, 1e5)) / (ratio * ratio), 1, rounding) << ratio;
  }
}

// A practically endless strip of height 2 h at the distance z fills 4 atan(h / z).
TEST(RectangleBySolidAngle, OfALongStripIsAnAngle) {
  for (double length : {1e7, 1e10}) {
    for (double z : {1e-10, 1e-3, 1.0}) {
      for (double h : {1e-4, 1.0, 1e4}) {
        if (h * z > 1e-15 * length && h < 1e-4 * length) {  // the ends lack 8 z h^2 / length^2
          EXPECT_NEAR(solid_angle(above(length, 2 * h, z * h)) / (4 * std::atan(1 / z)), 1, rounding)
              << length << ' ' << z;
          EXPECT_NEAR(solid_angle(above(2 * h, length, z * h)) / (4 * std::atan(1 / z)), 1, rounding)
              << length << ' ' << z;
        }
      }
    }
  }
}

// For lengths from 1e-10 to 1e10 m, a sample is a point of the rectangle, and its density is
// finite.
RC_GTEST_PROP(RectangleBySolidAngle, IsAPointOfTheRectangleInFloats, ()) {
  const auto size = [] {
    return *rc::gen::map(rc::gen::inRange(-9999, 10000), [](int x) { return std::pow(10.0, x / 1000.0); });
  };
  const auto sign = [] { return *rc::gen::element(-1.0, 1.0); };
  const Vec3<float> corner = Vec3<double>(sign() * size(), sign() * size(), sign() * size()).cast<float>();
  const float width = static_cast<float>(size()), height = static_cast<float>(size());
  const RectangleLight<float> light(corner, {width, 0, 0}, {0, height, 0});
  const Vec2<float> u = *rc::gen::elementOf(testing::edge_points<float>());
  const auto sample = RectangleBySolidAngle<float>(light).sample({0, 0, 0}, u);
  const auto density = static_cast<double>(sample.density.value());
  RC_ASSERT(density >= 0 && density <= 1e36 * (1 + rounding));
  const double extent = static_cast<double>(corner.lpNorm<1>() + width + height);
  // As documented: the plane is nearer than 1e-15 of the rest, or the solid angle is below 1e-36.
  if (density == 0) {
    const double z = static_cast<double>(std::abs(corner.z())), area = static_cast<double>(width * height);
    RC_ASSERT(z <= 1e-15 * extent || area * z <= 1e-35 * extent * extent * extent);
    return;
  }
  const double slack = 8 * 0x1p-23 * extent;
  const Vec3<double> hit =
      sample.direction.cast<double>() * static_cast<double>(sample.distance) - corner.cast<double>();
  RC_ASSERT(std::abs(sample.direction.norm() - 1) <= 4 * 0x1p-23f);
  RC_ASSERT(std::abs(hit.z()) <= slack);
  RC_ASSERT(hit.x() >= -slack && hit.x() <= static_cast<double>(width) + slack);
  RC_ASSERT(hit.y() >= -slack && hit.y() <= static_cast<double>(height) + slack);
}

TEST(RectangleBySolidAngle, IsNotSeenFromNearerThanFloatsTell) {
  EXPECT_GT(RectangleBySolidAngle<float>(above(2, 2, 2e-15)).sample({0, 0, 0}, {0.5f, 0.5f}).density.value(), 0);
  EXPECT_EQ(RectangleBySolidAngle<float>(above(2, 2, 0.5e-15)).sample({0, 0, 0}, {0.5f, 0.5f}).density.value(), 0);
  EXPECT_EQ(RectangleBySolidAngle<float>(above(2, 2, 0.5e-15)).pdf({0, 0, 0}, {0, 0, 1}).value(), 0);
}

// Sides of 1e-9 m at 1e10 m: t^2 / A = 1e38.
TEST(RectangleByArea, IsNotSeenWhereFloatsDoNotHoldItsDensity) {
  for (double z : {1e8, 1e10}) {
    const RectangleByArea<float> light(above(1e-9, 1e-9, z));
    const float density = light.sample({0, 0, 0}, {0.5f, 0.5f}).density.value();
    EXPECT_NEAR(static_cast<double>(density), z == 1e8 ? 1e34 : 0, 1e34 * rounding);
    EXPECT_EQ(light.pdf({0, 0, 0}, {0, 0, 1}).value() > 0, density > 0);
  }
}

TEST(RectangleLight, RefusesLengthsThatFloatsDoNotHold) {
  EXPECT_NO_THROW(above(1e-10, 1e10, 1));
  for (double wrong : {0.9e-10, 1.1e10}) {
    EXPECT_THROW(above(wrong, 1, 1), std::invalid_argument) << wrong;
    EXPECT_THROW(above(1, wrong, 1), std::invalid_argument) << wrong;
  }
  EXPECT_THROW(above(1, 1, 1.1e10), std::invalid_argument);
  EXPECT_THROW(RectangleLight<double>({0, 0, 0}, {1e76, 0, 0}, {0, 1, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

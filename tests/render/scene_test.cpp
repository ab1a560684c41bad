#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <fairlight/render/scene.h>

namespace fairlight {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const Rgb<double> grey(0.5, 0.5, 0.5);
const Rgb<double> none(0, 0, 0);

Scene two_spheres() {
  Scene scene;
  scene.add_sphere({0, 0, 0}, 1, grey, none);
  scene.add_sphere({5, 0, 0}, 1, grey, Rgb<double>(0, 2, 0));
  return scene;
}

TEST(Scene, FindsTheNearestSurface) {
  const auto hit = two_spheres().intersect<double>({{-3, 0, 0}, {1, 0, 0}, -1});
  EXPECT_EQ(hit.surface, 0);
  EXPECT_DOUBLE_EQ(hit.distance, 2);
}

TEST(Scene, FindsNothingWhereThereIsNothing) {
  EXPECT_EQ(two_spheres().intersect<double>({{-3, 0, 0}, {-1, 0, 0}, -1}).surface, -1);
}

TEST(Scene, HidesTheSecondSphereBehindTheFirst) {
  const Scene scene = two_spheres();
  EXPECT_FALSE(scene.visible<double>({{-3, 0, 0}, {1, 0, 0}, -1}, 7, 1));
  EXPECT_TRUE(scene.visible<double>({{5, 5, 0}, {0, -1, 0}, -1}, 4, 1));
  EXPECT_TRUE(scene.visible<double>({{1, 0, 0}, {1, 0, 0}, 0}, 3, 1)) << "leaving the first sphere";
}

TEST(Scene, KnowsWhatEmits) {
  const Scene scene = two_spheres();
  ASSERT_EQ(scene.luminaires().size(), 1u);
  EXPECT_EQ(scene.luminaires()[0].surface, 1);
  EXPECT_EQ(scene.luminaires()[0].centre, Vec3<double>(5, 0, 0));
  EXPECT_EQ(scene.luminaires()[0].radius, 1);
}

TEST(Scene, RefusesImpossibleSurfaces) {
  Scene scene;
  EXPECT_THROW(scene.add_sphere({0, 0, 0}, 0, grey, none), std::invalid_argument);
  EXPECT_THROW(scene.add_sphere({0, 0, 0}, -1, grey, none), std::invalid_argument);
  EXPECT_THROW(scene.add_sphere({0, 0, 0}, inf, grey, none), std::invalid_argument);
  EXPECT_THROW(scene.add_sphere({0, nan, 0}, 1, grey, none), std::invalid_argument);
  EXPECT_THROW(scene.add_sphere({0, 0, 0}, 1, Rgb<double>(0.5, 1.01, 0.5), none), std::invalid_argument);
  EXPECT_THROW(scene.add_sphere({0, 0, 0}, 1, Rgb<double>(0.5, -0.1, 0.5), none), std::invalid_argument);
  EXPECT_THROW(scene.add_sphere({0, 0, 0}, 1, grey, Rgb<double>(0, -1, 0)), std::invalid_argument);
  EXPECT_THROW(scene.add_sphere({0, 0, 0}, 1, grey, Rgb<double>(0, inf, 0)), std::invalid_argument);
  EXPECT_THROW(scene.add_wall({0, 0, 0}, {0, 2, 0}, 1e5, grey, none), std::invalid_argument);
  EXPECT_TRUE(scene.surfaces().empty());
}

}  // namespace
}  // namespace fairlight

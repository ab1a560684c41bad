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

TEST(Scene, KnowsWhatEmits) {
  const Scene scene = two_spheres();
  ASSERT_EQ(scene.luminaires().size(), 1u);
  EXPECT_EQ(scene.luminaires()[0].surface, 1);
  EXPECT_EQ(scene.luminaires()[0].centre, Vec3<double>(5, 0, 0));
  EXPECT_EQ(scene.luminaires()[0].radius, 1);
}

TEST(Scene, KnowsARectangleThatEmits) {
  Scene scene;
  scene.add_rectangle({1, 2, 3}, {4, 0, 0}, {0, 0, 3}, grey, Rgb<double>(3, 6, 0));
  ASSERT_EQ(scene.luminaires().size(), 1u);
  const Luminaire& light = scene.luminaires()[0];
  EXPECT_TRUE(light.is_rectangle);
  EXPECT_EQ(light.centre, Vec3<double>(3, 2, 4.5));
  EXPECT_DOUBLE_EQ(light.radius, 2.5);
  EXPECT_DOUBLE_EQ(power_of(light), M_PI * 12 * 3);
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
  const Rgb<double> one(1, 1, 1);
  EXPECT_THROW(scene.add_sphere({0, 0, 0}, 1, {Material::Kind::gloss, one, -1}, none), std::invalid_argument);
  EXPECT_THROW(scene.add_sphere({0, 0, 0}, 1, {Material::Kind::metal, one, 2}, none), std::invalid_argument);
  EXPECT_THROW(scene.add_sphere({0, 0, 0}, 1, {Material::Kind::glass, one, 0}, none), std::invalid_argument);
  EXPECT_THROW(scene.add_rectangle({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, grey, none), std::invalid_argument);
  EXPECT_THROW(scene.add_rectangle({0, 0, 0}, {1, 0, 0}, {0, 0, 0}, grey, none), std::invalid_argument);
  EXPECT_THROW(scene.add_rectangle({0, 0, 0}, {1, 0, 0}, {0, 1e-60, 0}, grey, none), std::invalid_argument);
  for (const double radius : {std::numeric_limits<double>::denorm_min(), 1e-310, 1e-60, 1e60}) {
    EXPECT_THROW(scene.add_sphere({0, 0, 0}, radius, grey, none), std::invalid_argument);
    EXPECT_THROW(scene.add_wall({0, 0, 0}, {0, 1, 0}, radius, grey, none), std::invalid_argument);
  }
  const Material glass(Material::Kind::glass, one, 1.5);
  EXPECT_THROW(scene.add_rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, glass, none), std::invalid_argument);
  EXPECT_TRUE(scene.surfaces().empty());
}

}  // namespace
}  // namespace fairlight

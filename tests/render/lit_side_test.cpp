#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/unit_square.h>

#include <fairlight/estimators/sphere_directions.h>
#include <fairlight/render/geometry.h>

namespace fairlight {
namespace {

const Rgb<double> grey(0.5, 0.5, 0.5);
const Rgb<double> none(0, 0, 0);
const Rgb<double> lit(1, 1, 1);
const Material glass(Material::Kind::glass, lit, 1.5);

// A sphere of radius 1 about the origin, which emits or not, and luminaires about (3, 0, 0) and (-3, 0, 0) of the given radii.
Scene between_two(const Material& material, double first, double second, const Rgb<double>& emitted = none) {
  Scene scene;
  scene.add_sphere({0, 0, 0}, 1, material, emitted);
  scene.add_sphere({3, 0, 0}, first, grey, lit);
  scene.add_sphere({-3, 0, 0}, second, grey, lit);
  return scene;
}

TEST(LitSide, IsWhereAllLuminairesAre) {
  EXPECT_EQ(lit_side(between_two(grey, 1, 1), 0), LitSide::outside);
  EXPECT_EQ(lit_side(between_two(grey, 1, 4.5), 0), LitSide::outside) << "one of them is around it";
  EXPECT_EQ(lit_side(between_two(grey, 1, 2.5), 0), LitSide::either) << "one of them cuts it";
  EXPECT_EQ(lit_side(between_two(grey, 2, 1), 0), LitSide::either) << "one of them touches it";
  Scene around;
  around.add_sphere({0, 0, 0}, 5, grey, none);
  around.add_sphere({3, 0, 0}, 1, grey, lit);
  EXPECT_EQ(lit_side(around, 0), LitSide::inside);
  around.add_sphere({0, 4.5, 0}, 1, grey, lit);
  EXPECT_EQ(lit_side(around, 0), LitSide::either) << "one of them cuts it";
  around.add_sphere({0, 9, 0}, 1, grey, lit);
  EXPECT_EQ(lit_side(around, 0), LitSide::either) << "they are on both sides";
}

TEST(LitSide, IsEitherOfWhatLetsLightThroughOrHasItsOwn) {
  EXPECT_EQ(lit_side(between_two(glass, 1, 1), 0), LitSide::either);
  EXPECT_EQ(lit_side(between_two(grey, 1, 1, lit), 0), LitSide::either);
  EXPECT_EQ(lit_side(between_two(grey, 1, 1), 1), LitSide::either) << "a luminaire";
  Scene unlit;
  unlit.add_sphere({0, 0, 0}, 1, grey, none);
  EXPECT_EQ(lit_side(unlit, 0), LitSide::either);
}

// A rectangle that is no part of a sphere's plane is in the sphere about it, of radius sqrt(2) here.
TEST(LitSide, HoldsARectangleToBeTheSphereAboutIt) {
  const auto with_rectangle_at = [](double x) {
    Scene scene;
    scene.add_sphere({0, 0, 0}, 2, grey, none);
    scene.add_rectangle({x, -1, -1}, {0, 2, 0}, {0, 0, 2}, grey, lit);
    return scene;
  };
  EXPECT_EQ(lit_side(with_rectangle_at(0.5), 0), LitSide::inside);
  EXPECT_EQ(lit_side(with_rectangle_at(0.6), 0), LitSide::either);
  EXPECT_EQ(lit_side(with_rectangle_at(3.4), 0), LitSide::either);
  EXPECT_EQ(lit_side(with_rectangle_at(3.5), 0), LitSide::outside);
}

TEST(Obstacles, AreNotWhatHasAllLightInside) {
  Scene scene;
  scene.add_sphere({0, 0, 0}, 5, grey, none);
  scene.add_sphere({0, 0, 0}, 1, grey, none);
  scene.add_sphere({3, 0, 0}, 1, grey, lit);
  EXPECT_FALSE(can_occlude(scene, 0)) << "around";
  EXPECT_TRUE(can_occlude(scene, 1)) << "in the middle";
  EXPECT_FALSE(can_occlude(scene, 2)) << "the only luminaire";
  scene.add_sphere({-3, 0, 0}, 1, grey, lit);
  EXPECT_TRUE(can_occlude(scene, 2)) << "of two";
}

// The floor y = 0, |x| <= 1, |z| <= 1, with a sphere of radius 1 at the given height.
TEST(Obstacles, AreNotRectanglesWithNothingBeyond) {
  const auto under_sphere_at = [](double height) {
    Scene scene;
    scene.add_rectangle({-1, 0, -1}, {2, 0, 0}, {0, 0, 2}, grey, none);
    scene.add_sphere({0, height, 0}, 1, grey, lit);
    return scene;
  };
  EXPECT_FALSE(can_occlude(under_sphere_at(2), 0));
  EXPECT_FALSE(can_occlude(under_sphere_at(1), 0)) << "it stands on the floor";
  EXPECT_TRUE(can_occlude(under_sphere_at(0.9), 0)) << "it is sunk in";
  EXPECT_TRUE(can_occlude(under_sphere_at(-0.9), 0));
  EXPECT_FALSE(can_occlude(under_sphere_at(-1), 0)) << "all of it is below";
  Scene with_wall = under_sphere_at(2);
  with_wall.add_rectangle({1, 0, -1}, {0, 2, 0}, {0, 0, 2}, grey, none);
  EXPECT_FALSE(can_occlude(with_wall, 0)) << "the wall stands on it";
  EXPECT_FALSE(can_occlude(with_wall, 2));
  with_wall.add_rectangle({2, -0.1, -1}, {0, 2, 0}, {0, 0, 2}, grey, none);
  EXPECT_TRUE(can_occlude(with_wall, 0)) << "this wall reaches below it";
}

// Exactly on the outside of a wall whose normal is as far from a unit vector as one may be.
TEST(LitSide, KnowsARadiusByItsNormal) {
  Scene scene;
  scene.add_wall({0, 0, 0}, {0.707106781, 0.707106781, 0}, 1e9, grey, none);
  scene.add_sphere({0.1 * 0.707106781, 0.1 * 0.707106781, 0}, 0.05, grey, lit);
  EXPECT_NE(lit_side(scene, 0), LitSide::inside);
}

// A room that is lit by a sphere or by two: spheres around and in the middle, or a floor below all of it; a rectangle, and glass.
Scene random_room() {
  const auto place = [] { return 6 * *testing::unit_number() - 3; };
  const auto size = [] { return 0.1 + *testing::unit_number(); };
  Scene scene;
  if (*rc::gen::arbitrary<bool>()) {
    scene.add_wall({-4, 0, 0}, {-1, 0, 0}, 1e3, grey, none);
    scene.add_sphere({0, 0, 0}, 6, grey, none);
  } else {
    scene.add_rectangle({-9, -5, -9}, {18, 0, 0}, {0, 0, 18}, grey, none);
  }
  scene.add_sphere({place(), place(), place()}, size(), glass, none);
  for (int i = 0; i < 4; ++i) scene.add_sphere({place(), place(), place()}, size(), grey, none);
  scene.add_rectangle({place(), place(), place()}, {size(), 0, 0}, {0, 0, size()}, grey, none);
  for (int i = *rc::gen::inRange(0, 2); i >= 0; --i)
    scene.add_sphere({place(), place(), place()}, size() / 4, grey, lit);
  return scene;
}

// Where a ray first meets one of the surfaces, and which; by each shape's own crossing.
Hit<double> first_of_all(const Scene& scene, const Ray<double>& ray) {
  Hit<double> first{infinity<double>, -1};
  for (std::size_t i = 0; i < scene.surfaces().size(); ++i) {
    const Surface& surface = scene.surfaces()[i];
    const bool leaving = ray.origin_primitive == static_cast<double>(i);
    const auto crossing = surface.rectangle ? surface.rectangle->crossing(ray.origin, ray.direction, leaving)
                                            : surface.shape.crossing(ray.origin, ray.direction, leaving);
    if (crossing.distance() < first.distance) first = {crossing.distance(), static_cast<double>(i)};
  }
  return first;
}

bool starts_unlit(const Scene& scene, const Vec3<double>& origin) {
  for (std::size_t i = 0; i < scene.surfaces().size(); ++i) {
    const double level = scene.surfaces()[i].shape.level(origin);
    const LitSide side = lit_side(scene, i);
    if ((side == LitSide::inside && level > 0) || (side == LitSide::outside && level < 0)) return true;
  }
  return false;
}

// A path from anywhere meets, bounce by bounce, what it would meet if every sphere was looked at from both sides; or nothing, where
// it starts without light. And shadow rays from where it goes are stopped where a ray would be.
RC_GTEST_PROP(LitSide, LosesNothingOfAPath, ()) {
  const Scene scene = random_room();
  const Geometry<double> geometry(scene);
  const auto place = [] { return 8 * *testing::unit_number() - 4; };
  const auto towards = [] { return UniformSphere<double>().sample(*testing::unit_point()); };
  Ray<double> ray{{place(), place(), place()}, towards(), -1};
  const bool unlit = starts_unlit(scene, ray.origin);
  for (int bounce = 0; bounce < 4; ++bounce) {
    const Hit<double> expected = first_of_all(scene, ray);
    const Hit<double> hit = geometry.intersect(ray);
    if (unlit || expected.surface < 0) {
      RC_ASSERT(hit.surface == -1);
      return;
    }
    RC_ASSERT(hit.surface == expected.surface);
    RC_ASSERT(std::abs(hit.distance - expected.distance) <= 1e-12 * (1 + expected.distance));
    const Vec3<double> position = ray.origin + hit.distance * ray.direction;
    const Vec3<double> outward = geometry.normal_at(static_cast<int>(hit.surface), position);
    const Vec3<double> normal = outward.dot(ray.direction) < 0 ? outward : Vec3<double>(-outward);
    for (const Luminaire& light : scene.luminaires()) {
      const Vec3<double> on_light = towards();
      const Vec3<double> way = light.centre + light.radius * on_light - position;
      if (normal.dot(way) < 0 || on_light.dot(way) > 0) continue;  // one of them does not face the other
      const Ray<double> shadow{position, way.normalized(), hit.surface};
      const bool reaches = first_of_all(scene, shadow).surface == light.surface;
      RC_ASSERT(geometry.visible(shadow, way.norm(), light.surface) == reaches);
    }
    Vec3<double> next = towards();
    if (next.dot(normal) < 0) next = -next;
    ray = {position, next, hit.surface};
  }
}

}  // namespace
}  // namespace fairlight

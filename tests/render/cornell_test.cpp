#include <stdexcept>

#include <gtest/gtest.h>

#include <fairlight/render/cornell.h>

namespace fairlight {
namespace {

struct Seen {
  int surface;
  Vec3<double> point;
};

Seen look(const View& view, Vec3<double> from, Vec3<double> direction) {
  const Ray<double> ray{from, direction.normalized(), -1};
  const auto hit = view.scene.intersect(ray);
  return {hit.surface, ray.origin + hit.distance * ray.direction};
}

TEST(CornellSimple, HasItsWallsWhereThePaperHasThem) {
  const View view = built_in_scene("cornell-simple");
  const Vec3<double> middle(50, 40.8, 81.6);
  EXPECT_NEAR(look(view, middle, {-1, 0, 0}).point.x(), 1, 1e-12);
  EXPECT_NEAR(look(view, middle, {1, 0, 0}).point.x(), 99, 1e-12);
  EXPECT_NEAR(look(view, middle, {0, 0, -1}).point.z(), 0, 1e-12);
  EXPECT_NEAR(look(view, middle, {0, -1, 0}).point.y(), 0, 1e-12);
  EXPECT_NEAR(look(view, {20, 40.8, 81.6}, {0, 1, 0}).point.y(), 81.6 - 30 * 30 / 2e5, 1e-6);  // bulged
  EXPECT_GT(look(view, middle, {0, 0, 1}).point.z(), 2000) << "no front, until the walls' spheres close far out";
}

TEST(CornellSimple, HasARedLeftAndABlueRightWall) {
  const View view = built_in_scene("cornell-simple");
  const auto albedo = [&](double x) {
    const int surface = look(view, {50, 40.8, 81.6}, {x, 0, 0}).surface;
    return view.scene.surfaces()[static_cast<std::size_t>(surface)].albedo;
  };
  EXPECT_TRUE((albedo(-1) == Rgb<double>(.75, .25, .25)).all());
  EXPECT_TRUE((albedo(1) == Rgb<double>(.25, .25, .75)).all());
}

TEST(CornellSimple, IsLitByOneSphere) {
  const View view = built_in_scene("cornell-simple");
  ASSERT_EQ(view.scene.luminaires().size(), 1u);
  const Luminaire& light = view.scene.luminaires()[0];
  EXPECT_TRUE(light.centre.isApprox(Vec3<double>(50, 65.1, 81.6)));
  EXPECT_EQ(light.radius, 1.5);
  EXPECT_TRUE((light.radiance == 400).all());
  EXPECT_TRUE((view.scene.surfaces()[static_cast<std::size_t>(light.surface)].albedo == 0).all());
}

TEST(BuiltInScene, ExistsForEveryName) {
  for (const std::string& name : scene_names()) EXPECT_EQ(built_in_scene(name).name, name);
}

TEST(BuiltInScene, NamesTheScenesThatExistWhenOneDoesNot) {
  try {
    built_in_scene("cornel");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("cornell-simple"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace fairlight

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include <fairlight/render/built_in_scenes.h>
#include <fairlight/render/geometry.h>

namespace fairlight {
namespace {

struct Seen {
  int surface;
  Vec3<double> point;
};

Seen look(const View& view, Vec3<double> from, Vec3<double> direction) {
  const Ray<double> ray{from, direction.normalized(), -1};
  const auto hit = Geometry<double>(view.scene).intersect(ray);
  return {static_cast<int>(hit.surface), ray.origin + hit.distance * ray.direction};
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
    return view.scene.surfaces()[static_cast<std::size_t>(surface)].material.albedo;
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
  EXPECT_TRUE((view.scene.surfaces()[static_cast<std::size_t>(light.surface)].material.albedo == 0).all());
}

TEST(CornellComplex, HasThreeSpheresAndTwoLights) {
  const View view = cornell_complex();
  EXPECT_NEAR(look(view, {20, 60, 40}, {0, -1, 0}).point.y(), 33, 1e-12);
  EXPECT_NEAR(look(view, {50, 60, 80}, {0, -1, 0}).point.y(), 33, 1e-12);
  EXPECT_NEAR(look(view, {75, 60, 120}, {0, -1, 0}).point.y(), 33, 1e-12);
  ASSERT_EQ(view.scene.luminaires().size(), 2u);
  EXPECT_TRUE(view.scene.luminaires()[0].centre.isApprox(Vec3<double>(50, 65.1, 40)));
  EXPECT_TRUE(view.scene.luminaires()[1].centre.isApprox(Vec3<double>(50, 65.1, 120)));
  EXPECT_NEAR(look(view, {36.5, 60, 80}, {0, -1, 0}).point.y(), 16.5 + std::sqrt(16.5 * 16.5 - 13.5 * 13.5), 1e-12);
  for (const Luminaire& light : view.scene.luminaires()) {
    EXPECT_EQ(light.radius, 1.5);
    EXPECT_TRUE((light.radiance == 400).all());
  }
}

int count_of(const View& view, Material::Kind kind) {
  return static_cast<int>(std::ranges::count_if(
      view.scene.surfaces(), [kind](const Surface& surface) { return surface.material.kind == kind; }));
}

TEST(CornellMaterials, HasABallOfEachMaterial) {
  const View view = cornell_materials();
  for (const Material::Kind kind :
       {Material::Kind::mirror, Material::Kind::glass, Material::Kind::metal, Material::Kind::gloss})
    EXPECT_EQ(count_of(view, kind), 1);
  EXPECT_EQ(view.scene.luminaires().size(), 1u);
}

// Seven balls on the floor, 40 apart, of which the third is seen sharp.
TEST(Hallway, IsSeenThroughALensAlongARowOfBalls) {
  const View view = built_in_scene("hallway");
  EXPECT_TRUE(view.camera.has_lens());
  const CameraSettings& camera = view.camera.settings();
  const double third = (Vec3<double>(-5, 8, -40) - camera.eye).dot(camera.look.normalized());
  EXPECT_NEAR(camera.focus_distance, third, 1);
  for (int i = 0; i < 7; ++i) {
    const Vec3<double> over(-14 + 4.5 * i, 40, 40.0 - 40 * i);
    EXPECT_NEAR(look(view, over, {0, -1, 0}).point.y(), 16, 1e-12) << "ball " << i;
  }
  EXPECT_EQ(view.scene.luminaires().size(), 3u);
}

// Corners of the measured tops, which the rectangles meet to a millimetre and a half.
TEST(CornellOriginal, HasItsBlocksWhereTheyWereMeasured) {
  const View view = cornell_original();
  const auto height = [&](double x, double z) { return look(view, {x, 500, z}, {0, -1, 0}).point.y(); };
  for (const Vec2<double>& corner : {Vec2<double>(130, 65), {82, 225}, {240, 272}, {290, 114}}) {
    const Vec2<double> inward = (Vec2<double>(185.5, 169) - corner).normalized();
    EXPECT_NEAR(height(corner.x() + 2 * inward.x(), corner.y() + 2 * inward.y()), 165, 1e-9);
    EXPECT_NEAR(height(corner.x() - 2 * inward.x(), corner.y() - 2 * inward.y()), 0, 1e-9);
  }
  for (const Vec2<double>& corner : {Vec2<double>(423, 247), {265, 296}, {314, 456}, {472, 406}}) {
    const Vec2<double> inward = (Vec2<double>(368.5, 351.25) - corner).normalized();
    EXPECT_NEAR(height(corner.x() + 2 * inward.x(), corner.y() + 2 * inward.y()), 330, 1e-9);
    EXPECT_NEAR(height(corner.x() - 2 * inward.x(), corner.y() - 2 * inward.y()), 0, 1e-9);
  }
}

TEST(ManyLights, AreAThousandOfUnequalPowers) {
  const View view = many_lights();
  EXPECT_EQ(view.scene.luminaires().size(), 1000u);
  EXPECT_GT(power_of(view.scene.luminaires()[6]), 5 * power_of(view.scene.luminaires()[0]));
}

TEST(BuiltInScene, ExistsForEveryName) {
  for (const std::string& name : scene_names()) EXPECT_EQ(built_in_scene(name).name, name);
}

TEST(BuiltInScene, NamesTheNearestWhereThereIsNone) {
  try {
    built_in_scene("halway");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("mean hallway? see fairlight scenes"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace fairlight

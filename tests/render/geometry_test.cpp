#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/unit_square.h>

#include <fairlight/estimators/sphere_directions.h>
#include <fairlight/render/geometry.h>

namespace fairlight {
namespace {

const Rgb<double> grey(0.5, 0.5, 0.5);
const Rgb<double> none(0, 0, 0);

// Spheres about (0, 0, 0) and (5, 0, 0), and between them the rectangle x = 2, |y| <= 1, |z| <= 2.
Scene three_surfaces() {
  Scene scene;
  scene.add_sphere({0, 0, 0}, 1, grey, none);
  scene.add_rectangle({2, -1, -2}, {0, 2, 0}, {0, 0, 4}, grey, none);
  scene.add_sphere({5, 0, 0}, 1, grey, none);
  return scene;
}

TEST(Geometry, FindsTheNearestSurface) {
  const Geometry<double> geometry(three_surfaces());
  const auto hit = geometry.intersect({{-3, 0, 0}, {1, 0, 0}, -1});
  EXPECT_EQ(hit.surface, 0);
  EXPECT_DOUBLE_EQ(hit.distance, 2);
  const auto next = geometry.intersect({{1, 0, 0}, {1, 0, 0}, 0});
  EXPECT_EQ(next.surface, 1);
  EXPECT_DOUBLE_EQ(next.distance, 1);
  EXPECT_EQ(geometry.intersect({{2, 0, 0}, {1, 0, 0}, 1}).surface, 2) << "leaving the rectangle";
  EXPECT_EQ(geometry.intersect({{1, 1.1, 0}, {1, 0, 0}, -1}).surface, -1) << "past the rectangle's edge";
}

TEST(Geometry, FindsNothingWhereThereIsNothing) {
  EXPECT_EQ(Geometry<double>(three_surfaces()).intersect({{-3, 0, 0}, {-1, 0, 0}, -1}).surface, -1);
  EXPECT_EQ(Geometry<double>(Scene()).intersect({{-3, 0, 0}, {-1, 0, 0}, -1}).surface, -1);
}

TEST(Geometry, HidesWhatIsBehind) {
  const Geometry<double> geometry(three_surfaces());
  EXPECT_FALSE(geometry.visible({{-3, 0, 0}, {1, 0, 0}, -1}, 5, 1)) << "through the first sphere";
  EXPECT_FALSE(geometry.visible({{1, 0, 0}, {1, 0, 0}, 0}, 3, 2)) << "through the rectangle";
  EXPECT_TRUE(geometry.visible({{1, 0, 0}, {1, 0, 0}, 0}, 1, 1)) << "leaving the first sphere";
  EXPECT_TRUE(geometry.visible({{5, 5, 0}, {0, -1, 0}, -1}, 4, 2));
  EXPECT_TRUE(geometry.visible({{-3, 0, 0}, {1, 0, 0}, -1}, 1.5, 2)) << "nothing is so near";
}

TEST(Geometry, KnowsItsNormals) {
  const Geometry<double> geometry(three_surfaces());
  EXPECT_TRUE(geometry.normal_at(0, {0, 0.6, 0.8}).isApprox(Vec3<double>(0, 0.6, 0.8)));
  EXPECT_TRUE(geometry.normal_at(1, {2, 0.5, 1}).isApprox(Vec3<double>(1, 0, 0)));
  EXPECT_TRUE(geometry.normal_at(2, {5, 1.1, 0}).isApprox(Vec3<double>(0, 1, 0))) << "off the surface";
}

// What stands in the way is what would be hit first.
RC_GTEST_PROP(Geometry, HidesWhatIntersectFinds, ()) {
  Scene scene;
  for (int i = 0; i < 4; ++i) {
    const auto place = [] { return 4 * *testing::unit_number() - 2; };
    scene.add_sphere({place(), place(), place()}, 0.1 + *testing::unit_number(), grey, none);
  }
  const Geometry<double> geometry(scene);
  const Ray<double> ray{{0, 0, 0}, UniformSphere<double>().sample(*testing::unit_point()), -1};
  const double reach = 1 + 3 * *testing::unit_number();
  const double nearest = geometry.intersect(ray).distance;
  RC_PRE(std::abs(nearest - reach) > 1e-9);
  RC_ASSERT(geometry.visible(ray, reach, -1) == (nearest > reach));
}

// Each lane sees what a ray of doubles sees, to 1e-5 where the box is 100 wide and its walls are spheres of radius 1e5.
RC_GTEST_PROP(Geometry, IsTheSameInPackets, ()) {
  Scene scene;
  scene.add_wall({1, 40, 80}, {-1, 0, 0}, 1e5, grey, none);
  scene.add_wall({99, 40, 80}, {1, 0, 0}, 1e5, grey, none);
  scene.add_wall({50, 0, 80}, {0, -1, 0}, 1e5, grey, none);
  scene.add_sphere({30, 16.5, 50}, 16.5, grey, none);
  scene.add_rectangle({60, 10, 10}, {20, 0, 0}, {0, 0, 50}, grey, none);
  if (*rc::gen::arbitrary<bool>()) scene.add_sphere({50, 60, 80}, 1.5, grey, grey);  // then one side is looked at
  const Vec3<double> direction = UniformSphere<double>().sample(*testing::unit_point());
  const auto hit = Geometry<double>(scene).intersect({{50, 40, 80}, direction, -1});
  const auto packets = Geometry<Packet>(scene).intersect(
      {Vec3<Packet>(Packet(50), Packet(40), Packet(80)), direction.cast<float>().cast<Packet>(), Packet(-1)});
  RC_PRE(hit.surface >= 0);
  std::array<double, lanes<Packet>> surface{}, distance{};
  store_lanes(packets.surface, surface.data());
  store_lanes(packets.distance, distance.data());
  RC_PRE(surface[0] == hit.surface);  // beside an edge, either
  RC_ASSERT(std::abs(distance[0] - hit.distance) <= 2e-6 * hit.distance / std::abs(direction.minCoeff()) + 1e-4);
}

}  // namespace
}  // namespace fairlight

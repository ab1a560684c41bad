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

// A box some 100 m wide, whose walls are spheres of radius 1e5 m, with a sphere and a rectangle in
// it. With a luminaire the spheres are looked at from one side.
Scene box(bool is_lit) {
  Scene scene;
  scene.add_wall({1, 40, 80}, {-1, 0, 0}, 1e5, grey, none);
  scene.add_wall({99, 40, 80}, {1, 0, 0}, 1e5, grey, none);
  scene.add_wall({50, 0, 80}, {0, -1, 0}, 1e5, grey, none);
  scene.add_sphere({30, 16.5, 50}, 16.5, grey, none);
  scene.add_rectangle({60, 10, 10}, {20, 0, 0}, {0, 0, 50}, grey, none);
  if (is_lit) scene.add_sphere({50, 60, 80}, 1.5, grey, grey);
  return scene;
}

// Whether a ray that is turned by no more than `angle` [rad] meets the surface, or nothing (-1), as
// does one beside an edge.
bool nearly_meets(const Geometry<double>& geometry, const Ray<double>& ray, double surface, double angle) {
  const Frame<double> about(ray.direction.normalized());
  for (int i = 0; i < 64; ++i) {
    const double turn = i * pi<double> / 32;
    const Vec3<double> turned = about.to_world({angle * std::cos(turn), angle * std::sin(turn), 1});
    if (geometry.intersect({ray.origin, turned.normalized(), ray.origin_primitive}).surface == surface) return true;
  }
  return false;
}

// Each lane has a ray of its own and sees what a ray of doubles sees: the same surface, or beside
// its edge the one behind; as far away. Along a ray from the middle of the box no term of a
// surface's level is above 150 m. Eight roundings of such, of 2^-24 each, move it by 7e-5 m, and
// turn a ray to an edge 10 m away or more by 7e-6 rad. Where a ray meets a surface at a small
// cosine it goes farther by so much over it, and, as the surface curves, at most twice that.
RC_GTEST_PROP(Geometry, IsTheSameInPackets, ()) {
  constexpr double moved = 8 * 150 * 0x1p-24, turned = moved / 10;
  const Scene scene = box(*rc::gen::arbitrary<bool>());
  const Geometry<double> geometry(scene);
  std::array<std::array<double, lanes<Packet>>, 3> directions{};
  for (std::size_t lane = 0; lane < lanes<Packet>; ++lane) {
    const Vec3<double> direction = UniformSphere<double>().sample(*testing::unit_point());
    for (int c = 0; c < 3; ++c) directions[static_cast<std::size_t>(c)][lane] = static_cast<float>(direction[c]);
  }
  Ray<Packet> rays{Vec3<Packet>(Packet(50), Packet(40), Packet(80)), zero<Vec3<Packet>>(), Packet(-1)};
  for (int c = 0; c < 3; ++c) load_lanes(directions[static_cast<std::size_t>(c)].data(), rays.direction[c]);
  const auto packets = Geometry<Packet>(scene).intersect(rays);
  const auto surfaces = testing::lanes_of(packets.surface), distances = testing::lanes_of(packets.distance);
  for (std::size_t lane = 0; lane < lanes<Packet>; ++lane) {
    const Ray<double> ray{{50, 40, 80}, {directions[0][lane], directions[1][lane], directions[2][lane]}, -1};
    const Hit<double> hit = geometry.intersect(ray);
    if (surfaces[lane] != hit.surface) {
      RC_ASSERT(nearly_meets(geometry, ray, surfaces[lane], turned));
    } else if (hit.surface < 0) {
      RC_ASSERT(distances[lane] == infinity<double>);
    } else {
      const Vec3<double> at = ray.origin + hit.distance * ray.direction;
      const double cosine = std::abs(geometry.normal_at(static_cast<int>(hit.surface), at).dot(ray.direction));
      RC_ASSERT(std::abs(distances[lane] - hit.distance) * cosine <= 2 * moved);
    }
  }
}

}  // namespace
}  // namespace fairlight

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/unit_square.h>

#include <fairlight/estimators/hemisphere.h>
#include <fairlight/estimators/sphere_directions.h>
#include <fairlight/render/sphere.h>

namespace fairlight {
namespace {

// The unit sphere about the origin, anchored at its north pole.
const Sphere<double> unit{{0, 0, 1}, {0, 0, 1}, 1};

TEST(Sphere, IsHitFromWithoutFromWithinAndNotFromBehind) {
  EXPECT_DOUBLE_EQ(unit.crossing({3, 0, 0}, {-1, 0, 0}, false).distance(), 2);
  EXPECT_DOUBLE_EQ(unit.crossing({0, 0, 0}, {0.6, 0.8, 0}, false).distance(), 1);
  EXPECT_EQ(unit.crossing({3, 0, 0}, {1, 0, 0}, false).distance(), infinity<double>);
  EXPECT_EQ(unit.crossing({3, 0, 1.5}, {-1, 0, 0}, false).distance(), infinity<double>);
}

TEST(Sphere, IsNotHitWhereARayLeavesIt) {
  EXPECT_EQ(unit.crossing({1, 0, 0}, {1, 0, 0}, true).distance(), infinity<double>);
  EXPECT_DOUBLE_EQ(unit.crossing({1, 0, 0}, {-1, 0, 0}, true).distance(), 2);
}

// From without as from anywhere: ahead, past it, away from it, and off it; from within the level says so.
TEST(Sphere, IsEnteredFromWithoutAlone) {
  const auto entry = [](const Vec3<double>& origin, const Vec3<double>& direction, bool leaving) {
    const auto [crossing, twice_implicit] = unit.entry(origin, direction, leaving);
    EXPECT_DOUBLE_EQ(twice_implicit, leaving ? 0 : origin.squaredNorm() - 1);
    return crossing.before(RationalHit<double>::nowhere()) ? crossing.distance() : infinity<double>;
  };
  EXPECT_DOUBLE_EQ(entry({3, 0, 0}, {-1, 0, 0}, false), 2);
  EXPECT_EQ(entry({3, 0, 1.5}, {-1, 0, 0}, false), infinity<double>);
  EXPECT_EQ(entry({3, 0, 0}, {1, 0, 0}, false), infinity<double>);
  EXPECT_EQ(entry({1, 0, 0}, {0.6, 0.8, 0}, true), infinity<double>);
  EXPECT_EQ(entry({1, 0, 0}, {0, 1, 0}, true), infinity<double>);
  EXPECT_EQ(entry({0, 0, 0}, {0.6, 0.8, 0}, false), infinity<double>);
}

TEST(Sphere, IsLeftFromWithinAlone) {
  const auto exit = [](const Vec3<double>& origin, const Vec3<double>& direction, bool leaving) {
    const auto [crossing, twice_implicit] = unit.exit(origin, direction, leaving);
    EXPECT_DOUBLE_EQ(twice_implicit, leaving ? 0 : origin.squaredNorm() - 1);
    return crossing.before(RationalHit<double>::nowhere()) ? crossing.distance() : infinity<double>;
  };
  EXPECT_DOUBLE_EQ(exit({0.5, 0, 0}, {1, 0, 0}, false), 0.5);
  EXPECT_DOUBLE_EQ(exit({0.5, 0, 0}, {-1, 0, 0}, false), 1.5);
  EXPECT_DOUBLE_EQ(exit({0, 0, 0}, {0.6, 0.8, 0}, false), 1);
  EXPECT_DOUBLE_EQ(exit({1, 0, 0}, {-0.6, 0.8, 0}, true), 1.2);
  EXPECT_EQ(exit({1, 0, 0}, {0.6, 0.8, 0}, true), infinity<double>);
  EXPECT_EQ(exit({3, 0, 0}, {1, 0, 0}, false), infinity<double>);
}

TEST(Sphere, OfCurvatureZeroIsAPlane) {
  const Sphere<double> plane{{0, 0, 5}, {0, 0, 1}, 0};
  EXPECT_DOUBLE_EQ(plane.crossing({1, 2, 0}, {0, 0.6, 0.8}, false).distance(), 6.25);
  EXPECT_EQ(plane.crossing({1, 2, 0}, {0, 0.6, -0.8}, false).distance(), infinity<double>);
  EXPECT_EQ(plane.crossing({1, 2, 0}, {1, 0, 0}, false).distance(), infinity<double>);
  EXPECT_EQ(plane.crossing({1, 2, 5}, {0, 0.6, -0.8}, true).distance(), infinity<double>);
}

TEST(Sphere, HasALevelAndANormal) {
  EXPECT_DOUBLE_EQ(unit.level({0, 2, 0}), 1.5);  // (|x|^2 - 1) / 2
  EXPECT_DOUBLE_EQ(unit.level({0, 0, 0}), -0.5);
  EXPECT_TRUE(unit.normal_at({0, 1, 0}).isApprox(Vec3<double>(0, 1, 0)));
}

// A wall of radius 1e5, seen from inside at x = 1. With centre and radius, |x - c|^2 - r^2 would lose ten digits.
TEST(Sphere, OfLargeRadiusLosesNothing) {
  const Sphere<double> wall{{1, 40, 80}, {-1, 0, 0}, 1e-5};
  EXPECT_DOUBLE_EQ(wall.crossing({50, 40, 80}, {-1, 0, 0}, false).distance(), 49);
  // Off the axis by y the wall is nearer by y^2 / 2r, up to (y/r)^4 r / 8: 0.1 off by 5e-8.
  EXPECT_NEAR(wall.crossing({50, 40.1, 80}, {-1, 0, 0}, false).distance(), 49 - 5e-8, 1e-14);
}

// From inside, by a hundredth of the radius and more, every ray meets it.
RC_GTEST_PROP(Sphere, IsHitOnItself, ()) {
  const double radius = std::exp(*rc::gen::inRange(-7000, 11513) * 1e-3);  // 1e-3 to 1e5
  Vec3<double> outward = UniformHemisphere<double>().sample(*testing::unit_point());
  const Sphere<double> sphere{{1, -2, 3}, outward, 1 / radius};
  const Vec3<double> origin = Vec3<double>(1, -2, 3) - outward * radius * (0.01 + 0.99 * *testing::unit_number());
  const Vec3<double> direction = UniformSphere<double>().sample(*testing::unit_point());
  const double t = sphere.crossing(origin, direction, false).distance();
  RC_ASSERT(t < infinity<double>);
  // The level is a distance: rounded by the radius, by the step of length t, and by places of about 4.
  RC_ASSERT(std::abs(sphere.level(origin + t * direction)) <= 1e-14 * (radius + t + 0.4));
}

// Leaving a sphere for its inside, the ray meets it again at the chord's end; for its outside, never: at any scale.
RC_GTEST_PROP(Sphere, LetsARayLeaveAtAnyScale, ()) {
  const double radius = std::pow(10, *rc::gen::inRange(-6, 9));
  const Vec3<double> outward = UniformHemisphere<double>().sample(*testing::unit_point());
  const Sphere<double> sphere{radius * outward, outward, 1 / radius};
  const Vec3<double> w = UniformHemisphere<double>().sample(*testing::unit_point());
  RC_PRE(w.z() > 1e-6);
  const Vec3<double> away = Frame<double>(outward).to_world(w);
  RC_ASSERT(sphere.crossing(radius * outward, away, true).distance() == infinity<double>);
  RC_ASSERT(std::abs(sphere.crossing(radius * outward, -away, true).distance() / (2 * radius * w.z()) - 1) < 1e-9);
}

// A ray of floats that passes the centre of the unit sphere, 1e5 away, at a tenth more or less than its radius: the place where it
// starts is rounded to 0.01, and 1e10, of which the discriminant is the rest, to 1000.
RC_GTEST_PROP(Sphere, IsNoWiderFromFarAway, ()) {
  const auto distance = *rc::gen::element(1e2, 1e3, 1e4, 1e5);
  const Frame<double> frame(UniformSphere<double>().sample(*testing::unit_point()));
  const Sphere<float> sphere{{0, 0, 1}, {0, 0, 1}, 1};
  const Vec3<float> direction = frame.to_world({0, 0, 1}).cast<float>().normalized();
  const auto passed = [&](double aside) {
    const Vec3<float> origin = frame.to_world({aside, 0, -distance}).cast<float>();
    const bool hit = sphere.crossing(origin, direction, false).distance() < infinity<float>;
    const auto shadow = [&](double reach) {
      return sphere.obstruction(origin, direction, false, static_cast<float>(reach)) > 0;
    };
    RC_ASSERT(hit == shadow(2 * distance));
    RC_ASSERT(!shadow(distance - 3));
    RC_ASSERT(shadow(distance) == (aside < 1));
    return hit;
  };
  RC_ASSERT(passed(0));
  RC_ASSERT(passed(0.9));
  RC_ASSERT(!passed(1.1));
  RC_ASSERT(!passed(3));
}

}  // namespace
}  // namespace fairlight

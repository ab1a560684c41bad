#include <array>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/unit_square.h>

#include <fairlight/estimators/hemisphere.h>
#include <fairlight/estimators/vec.h>

namespace fairlight {
namespace {

void expect_orthonormal(const Vec3<double>& normal) {
  const Frame<double> frame(normal);
  const Vec3<double> x = frame.to_world({1, 0, 0});
  const Vec3<double> y = frame.to_world({0, 1, 0});
  EXPECT_EQ(frame.to_world({0, 0, 1}), normal);
  EXPECT_LE(std::abs(x.dot(y)) + std::abs(x.dot(normal)) + std::abs(y.dot(normal)), 1e-15) << normal.transpose();
  EXPECT_LE((x.cross(y) - normal).norm(), 2e-15) << normal.transpose();
}

TEST(Frame, IsOrthonormalAboutTheAxesAndNearThePole) {
  for (int i = 0; i < 3; ++i) {
    expect_orthonormal(Vec3<double>::Unit(i));
    expect_orthonormal(-Vec3<double>::Unit(i));
  }
  expect_orthonormal(Vec3<double>(1e-9, -1e-9, -1).normalized());
}

TEST(Frame, IsOneForBothZeros) {
  const Vec3<double> local(0.1, 0.2, 0.3);
  EXPECT_EQ(Frame<double>({0.6, 0.8, 0.0}).to_world(local), Frame<double>({0.6, 0.8, -0.0}).to_world(local));
}

RC_GTEST_PROP(Frame, TakesAVectorThereAndBack, ()) {
  Vec3<double> normal = UniformHemisphere<double>().sample(*testing::unit_point());
  if (*rc::gen::arbitrary<bool>()) normal = -normal;
  const Frame<double> frame(normal);
  const Vec3<double> local = UniformHemisphere<double>().sample(*testing::unit_point());
  RC_ASSERT((frame.to_local(frame.to_world(local)) - local).norm() <= 4e-15);
}

// 3 e: of a normal n that is too long by e, the square of a tangent's length by 2 e, and n itself by e.
RC_GTEST_PROP(Frame, IsOffByAsMuchAsItsNormal, ()) {
  constexpr double e = 1e-6;
  Vec3<double> normal = UniformHemisphere<double>().sample(*testing::unit_point());
  if (*rc::gen::arbitrary<bool>()) normal = -normal;
  const Frame<double> frame(normal), off(normal * (1 + e));
  const Vec3<double> local = UniformHemisphere<double>().sample(*testing::unit_point());
  RC_ASSERT((off.to_world(local) - frame.to_world(local)).norm() <= 4 * e);
  RC_ASSERT((off.to_local(local) - frame.to_local(local)).norm() <= 4 * e);
}

TEST(RequireUnit, RefusesAnyOtherLengthInEveryLane) {
  EXPECT_NO_THROW(require_unit<double>({0.6, 0, 0.8}, "it"));
  EXPECT_THROW(require_unit<double>({0.6, 0, 0.81}, "it"), std::invalid_argument);
  EXPECT_THROW(require_unit<double>({0, 0, 0}, "it"), std::invalid_argument);
  EXPECT_THROW(require_unit<double>({NAN, 0, 1}, "it"), std::invalid_argument);
  const Packet x(0.6f);
  EXPECT_NO_THROW(require_unit<Packet>({x, Packet(0), Packet(0.8f)}, "it"));
  std::array<float, lanes<Packet>> lengths{};
  lengths.fill(1);
  lengths.back() = 2;
  EXPECT_THROW(require_unit<Packet>({Packet(0), Packet(0), Packet::load_unaligned(lengths.data())}, "it"),
               std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

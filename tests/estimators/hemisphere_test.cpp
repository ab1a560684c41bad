#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/unit_square.h>

#include <fairlight/estimators/concepts.h>
#include <fairlight/estimators/hemisphere.h>

namespace fairlight {
namespace {

using testing::edge_points;
using testing::unit_point;

static_assert(Sampler<UniformHemisphere<double>>);
static_assert(Sampler<CosineHemisphere<double>>);

TEST(UniformHemisphere, HasTheDensityOneOverTwoPi) {
  const UniformHemisphere<double> hemisphere;
  EXPECT_DOUBLE_EQ(hemisphere.pdf({0, 0, 1}).value(), 1 / (2 * M_PI));
  EXPECT_DOUBLE_EQ(hemisphere.pdf({1, 0, 0}).value(), 1 / (2 * M_PI));
  EXPECT_EQ(hemisphere.pdf({0, 0, -1}).value(), 0);
}

TEST(UniformHemisphere, TakesHeightFromTheFirstNumberAndTurnFromTheSecond) {
  const Vec3<double> w = UniformHemisphere<double>().sample({0.6, 0.25});
  EXPECT_TRUE(w.isApprox(Vec3<double>(0, 0.8, 0.6), 1e-15)) << w.transpose();
}

TEST(CosineHemisphere, HasTheDensityCosineOverPi) {
  const CosineHemisphere<double> hemisphere;
  EXPECT_DOUBLE_EQ(hemisphere.pdf({0, 0, 1}).value(), 1 / M_PI);
  EXPECT_DOUBLE_EQ(hemisphere.pdf({0, 0.8, 0.6}).value(), 0.6 / M_PI);
  EXPECT_EQ(hemisphere.pdf({1, 0, 0}).value(), 0);
  EXPECT_EQ(hemisphere.pdf({0, 0, -1}).value(), 0);
}

TEST(CosineHemisphere, TakesTheDiskRadiusFromTheFirstNumber) {
  const Vec3<double> w = CosineHemisphere<double>().sample({0.36, 0.5});
  EXPECT_TRUE(w.isApprox(Vec3<double>(-0.6, 0, 0.8), 1e-15)) << w.transpose();
}

template <class Law>
class HemisphereLaw : public ::testing::Test {};
using Laws = ::testing::Types<UniformHemisphere<double>, CosineHemisphere<double>>;
TYPED_TEST_SUITE(HemisphereLaw, Laws);

TYPED_TEST(HemisphereLaw, GivesUnitVectorsInItsSupportAtTheEdgesOfTheSquare) {
  const TypeParam law;
  for (const Vec2<double>& u : edge_points()) {
    const Vec3<double> w = law.sample(u);
    EXPECT_LE(std::abs(w.norm() - 1), 4e-16) << u.transpose();
    EXPECT_GT(law.pdf(w).value(), 0) << u.transpose();
  }
}

TYPED_TEST(HemisphereLaw, GivesUnitVectorsInItsSupport) {
  rc::check([] {
    const TypeParam law;
    const Vec3<double> w = law.sample(*unit_point());
    RC_ASSERT(std::abs(w.norm() - 1) <= 4e-16);
    RC_ASSERT(law.pdf(w).value() > 0);
  });
}

// The warp maps areas of the square to solid angles: |dw/du x dw/dv| = 1/p.
TYPED_TEST(HemisphereLaw, HasTheJacobianOneOverItsDensity) {
  rc::check([] {
    const TypeParam law;
    const Vec2<double> u = Vec2<double>::Constant(0.01) + 0.98 * *unit_point();
    constexpr double h = 1e-6;
    const Vec3<double> du = (law.sample(u + Vec2<double>(h, 0)) - law.sample(u - Vec2<double>(h, 0))) / (2 * h);
    const Vec3<double> dv = (law.sample(u + Vec2<double>(0, h)) - law.sample(u - Vec2<double>(0, h))) / (2 * h);
    const double jacobian = du.cross(dv).norm() * law.pdf(law.sample(u)).value();
    RC_ASSERT(std::abs(jacobian - 1) < 1e-6);
  });
}

}  // namespace
}  // namespace fairlight

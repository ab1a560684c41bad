#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/direction_law.h>

#include <fairlight/estimators/hemisphere.h>

namespace fairlight {
namespace {

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
  testing::expect_unit_vectors_in_the_support(TypeParam());
  testing::expect_inverses_in_the_square(TypeParam());
}

TYPED_TEST(HemisphereLaw, GivesUnitVectorsInItsSupport) {
  EXPECT_TRUE(rc::check([] {
    const TypeParam law;
    const Vec3<double> w = law.sample(*unit_point());
    RC_ASSERT(std::abs(w.norm() - 1) <= 4e-16);
    RC_ASSERT(law.pdf(w).value() > 0);
  }));
}

TYPED_TEST(HemisphereLaw, HasTheJacobianOneOverItsDensity) {
  EXPECT_TRUE(rc::check([] { testing::check_jacobian(TypeParam()); }));
}

TYPED_TEST(HemisphereLaw, IsInvertedByItsInverse) {
  EXPECT_TRUE(rc::check([] { testing::check_round_trip(TypeParam(), 4e-15); }));
}

TEST(UniformHemisphere, IsTheSameInPackets) {
  testing::expect_packets_agree([]<class Real>(std::type_identity<Real>) { return UniformHemisphere<Real>(); },
                                2e-6);
  testing::expect_inverses_in_the_square(UniformHemisphere<Packet>());
}

TEST(CosineHemisphere, IsTheSameInPackets) {
  testing::expect_packets_agree([]<class Real>(std::type_identity<Real>) { return CosineHemisphere<Real>(); },
                                2e-6);
  testing::expect_inverses_in_the_square(CosineHemisphere<Packet>());
}

// The height (or its square) and the azimuth of a direction give back its random numbers.
TEST(UniformHemisphere, IsInvertedByReadingItsHeightAndTurn) {
  EXPECT_TRUE(UniformHemisphere<double>().invert({0, 0.8, 0.6}).isApprox(Vec2<double>(0.6, 0.25), 1e-15));
}

TEST(CosineHemisphere, IsInvertedByReadingTheDiskItProjectsTo) {
  EXPECT_TRUE(CosineHemisphere<double>().invert({-0.6, 0, 0.8}).isApprox(Vec2<double>(0.36, 0.5), 1e-15));
}

}  // namespace
}  // namespace fairlight

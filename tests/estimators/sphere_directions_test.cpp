#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/direction_law.h>

#include <fairlight/estimators/sphere_directions.h>

namespace fairlight {
namespace {

static_assert(Sampler<UniformSphere<double>>);

TEST(UniformSphere, HasTheDensityOneOverFourPiInEveryDirection) {
  EXPECT_DOUBLE_EQ(UniformSphere<double>().pdf({0, 0, 1}).value(), 1 / (4 * M_PI));
  EXPECT_DOUBLE_EQ(UniformSphere<double>().pdf({0, 0, -1}).value(), 1 / (4 * M_PI));
}

TEST(UniformSphere, TakesHeightFromTheFirstNumberAndTurnFromTheSecond) {
  EXPECT_EQ(UniformSphere<double>().sample({0, 0}), Vec3<double>(0, 0, 1));
  EXPECT_TRUE(UniformSphere<double>().sample({0.9, 0.5}).isApprox(Vec3<double>(-0.6, 0, -0.8), 1e-15));
}

TEST(UniformSphere, IsInvertedAtThePolesAndOnTheEquator) {
  EXPECT_EQ(UniformSphere<double>().invert({0, 0, 1}), Vec2<double>(0, 0));
  EXPECT_EQ(UniformSphere<double>().invert({0, 0, -1}), Vec2<double>(1, 0));
  EXPECT_EQ(UniformSphere<double>().invert({0, -1, 0}), Vec2<double>(0.5, 0.75));
}

TEST(UniformSphere, GivesUnitVectorsAtTheEdgesOfTheSquare) {
  testing::expect_unit_vectors_in_the_support(UniformSphere<double>());
  testing::expect_unit_vectors_in_the_support(UniformSphere<float>());
  testing::expect_unit_vectors_in_the_support(UniformSphere<Packet>());
  testing::expect_inverses_in_the_square(UniformSphere<double>());
  testing::expect_inverses_in_the_square(UniformSphere<float>());
  testing::expect_inverses_in_the_square(UniformSphere<Packet>());
}

RC_GTEST_PROP(UniformSphere, HasTheJacobianOneOverItsDensity, ()) {
  testing::check_jacobian(UniformSphere<double>());
}

RC_GTEST_PROP(UniformSphere, IsInvertedByItsInverse, ()) {
  testing::check_round_trip(UniformSphere<double>(), 4e-15);
}

TEST(UniformSphere, IsTheSameInPackets) {
  testing::expect_packets_agree([]<class Real>(std::type_identity<Real>) { return UniformSphere<Real>(); }, 2e-6);
}

}  // namespace
}  // namespace fairlight

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/direction_law.h>

#include <fairlight/estimators/cone.h>

namespace fairlight {
namespace {

static_assert(Sampler<UniformCone<double>>);

// sin^2 of the half angle is from 1e-16 to 1.
UniformCone<double> any_cone() {
  return UniformCone<double>::of_sine_squared(std::pow(10.0, -16 * *testing::unit_number()));
}

TEST(UniformCone, OfSixtyDegreesHasTheDensityOneOverPi) {
  for (const auto& cone : {UniformCone<double>(0.5), UniformCone<double>::of_sine_squared(0.75)}) {
    EXPECT_DOUBLE_EQ(cone.solid_angle(), M_PI);
    EXPECT_DOUBLE_EQ(cone.pdf({0, 0, 1}).value(), 1 / M_PI);
    EXPECT_DOUBLE_EQ(cone.pdf({0.8, 0, 0.6}).value(), 1 / M_PI);
    EXPECT_EQ(cone.pdf({0, 1, 0}).value(), 0);
    EXPECT_EQ(cone.pdf({0, 0, -1}).value(), 0);
  }
}

TEST(UniformCone, OfAStraightAngleIsTheSphere) {
  const UniformCone<double> cone(2);
  EXPECT_DOUBLE_EQ(cone.solid_angle(), 4 * M_PI);
  EXPECT_TRUE(cone.sample({0.9, 0.25}).isApprox(Vec3<double>(0, 0.6, -0.8), 1e-15));
  EXPECT_GT(cone.pdf({0, 0, -1}).value(), 0);
}

TEST(UniformCone, TakesHeightFromTheFirstNumberAndTurnFromTheSecond) {
  const UniformCone<double> cone(0.5);
  EXPECT_EQ(cone.sample({0, 0}), Vec3<double>(0, 0, 1));
  EXPECT_TRUE(cone.sample({0.4, 0.5}).isApprox(Vec3<double>(-0.6, 0, 0.8), 1e-15));
}

// A cone of 1e-8 rad, where cos(theta_max) rounds to 1 in double. Its solid angle is pi
// theta_max^2, half of the draws are within theta_max / sqrt(2), and a direction at 2 theta_max is
// outside.
template <class Real>
void expect_precision_of_a_tiny_cone() {
  using std::abs;
  const auto cone = UniformCone<Real>::of_sine_squared(rounded<Real>(1e-16));
  const Real eps = Real(4) * ulp<Real>;
  EXPECT_TRUE(all(abs(cone.solid_angle() / rounded<Real>(M_PI * 1e-16) - Real(1)) <= eps));
  const Vec3<Real> w = cone.sample({Real(0.5), Real(0)});
  EXPECT_TRUE(all(abs(w.x() / rounded<Real>(1e-8 * M_SQRT1_2) - Real(1)) <= eps));
  EXPECT_TRUE(all(cone.pdf(w).value() > Real(0)));
  EXPECT_TRUE(all(cone.pdf({rounded<Real>(2e-8), Real(0), Real(1)}).value() == Real(0)));
  EXPECT_TRUE(all(abs(cone.invert(w).x() - Real(0.5)) <= eps));
}

TEST(UniformCone, KeepsEveryDigitOfATinyAngle) {
  expect_precision_of_a_tiny_cone<double>();
  expect_precision_of_a_tiny_cone<float>();
  expect_precision_of_a_tiny_cone<Packet>();
}

template <class Real>
void expect_edges() {
  for (double height : {5e-17, 1e-9, 1e-3, 0.3, 0.999999, 1.0, 1.5, 2.0}) {
    testing::expect_unit_vectors_in_the_support(UniformCone<Real>(rounded<Real>(height)));
    testing::expect_inverses_in_the_square(UniformCone<Real>(rounded<Real>(height)));
  }
}

TEST(UniformCone, KeepsItsDrawsInsideAtTheEdgesOfTheSquare) {
  expect_edges<double>();
  expect_edges<float>();
  expect_edges<Packet>();
}

RC_GTEST_PROP(UniformCone, KeepsItsDrawsInsideAtItsEdge, ()) {
  const auto cone = any_cone();
  RC_ASSERT(cone.pdf(cone.sample({1 - 0x1p-53, *testing::unit_number()})).value() > 0);
}

RC_GTEST_PROP(UniformCone, KeepsItsDrawsInsideAtItsEdgeInFloat, ()) {
  const auto cone =
      UniformCone<float>::of_sine_squared(static_cast<float>(std::pow(10.0, -16 * *testing::unit_number())));
  const auto turn = static_cast<float>(std::floor(*testing::unit_number() * 0x1p24) * 0x1p-24);
  RC_ASSERT(cone.pdf(cone.sample({1 - 0x1p-24f, turn})).value() > 0);
}

RC_GTEST_PROP(UniformCone, HasTheJacobianOneOverItsDensity, ()) { testing::check_jacobian(any_cone()); }

RC_GTEST_PROP(UniformCone, IsInvertedByItsInverse, ()) { testing::check_round_trip(any_cone(), 4e-15); }

RC_GTEST_PROP(UniformCone, IsInvertedByItsInverseBeyondARightAngle, ()) {
  const UniformCone<double> cone(1 + *testing::unit_number());
  testing::check_jacobian(cone);
  testing::check_round_trip(cone, 4e-15);
}

TEST(UniformCone, IsTheSameInPackets) {
  for (double height : {5e-17, 0.3, 1.5}) {
    testing::expect_packets_agree(
        [=]<class Real>(std::type_identity<Real>) { return UniformCone<Real>(rounded<Real>(height)); }, 2e-6);
  }
}

TEST(UniformCone, RefusesAnAngleThatIsNone) {
  EXPECT_THROW(UniformCone<double>(0), std::invalid_argument);
  EXPECT_THROW(UniformCone<double>(2.1), std::invalid_argument);
  EXPECT_THROW(UniformCone<double>(std::nan("")), std::invalid_argument);
  EXPECT_THROW(UniformCone<double>::of_sine_squared(0), std::invalid_argument);
  EXPECT_THROW(UniformCone<double>::of_sine_squared(1.1), std::invalid_argument);
  EXPECT_THROW(UniformCone<Packet>(Packet(0)), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

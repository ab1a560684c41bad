#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/direction_law.h>

#include <fairlight/estimators/lobe.h>

namespace fairlight {
namespace {

static_assert(Sampler<PowerCosineLobe<double>>);

const Vec3<double> tilted(2.0 / 3, -1.0 / 3, 2.0 / 3);

// Exponents from 0.001 to 1e6, log-uniform.
double any_exponent() { return std::pow(10.0, -3 + 9 * *testing::unit_number()); }

TEST(PowerCosineLobe, HasTheDensityOfACosineToThePower) {
  const PowerCosineLobe<double> lobe({0, 0, 1}, 3);
  EXPECT_DOUBLE_EQ(lobe.pdf({0, 0, 1}).value(), 2 / M_PI);
  EXPECT_DOUBLE_EQ(lobe.pdf({0, 0.8, 0.6}).value(), 2 / M_PI * 0.216);
  EXPECT_EQ(lobe.pdf({1, 0, 0}).value(), 0);
  EXPECT_EQ(lobe.pdf({0, 0, -1}).value(), 0);
}

TEST(PowerCosineLobe, OfExponentZeroIsUniformOverItsHemisphere) {
  const PowerCosineLobe<double> lobe({0, 0, 1}, 0);
  EXPECT_DOUBLE_EQ(lobe.pdf({0, 0.8, 0.6}).value(), 1 / (2 * M_PI));
  EXPECT_EQ(lobe.pdf({0, 0.8, -0.6}).value(), 0);
}

// cos(alpha)^4 = 1 - u.
TEST(PowerCosineLobe, TakesTheCosineFromTheFirstNumberAndTheTurnFromTheSecond) {
  const Vec3<double> w = PowerCosineLobe<double>({0, 0, 1}, 3).sample({1 - 0.1296, 0.25});
  EXPECT_TRUE(w.isApprox(Vec3<double>(0, 0.8, 0.6), 1e-15)) << w.transpose();
}

TEST(PowerCosineLobe, LiesAboutItsAxis) {
  const PowerCosineLobe<double> lobe(tilted, 3);
  EXPECT_TRUE(lobe.sample({0, 0}).isApprox(tilted, 1e-15));
  EXPECT_DOUBLE_EQ(lobe.sample({1 - 0.6561, 0.3}).dot(tilted), 0.9);
}

template <class Real>
void expect_edges() {
  for (double exponent : {1.0, 5.0, 100.0, 1e4, 1e6}) {
    for (const Vec3<double>& axis :
         {Vec3<double>(0, 0, 1), tilted, Vec3<double>(0, 1, 0), Vec3<double>(0, 0, -1)}) {
      const Vec3<Real> about = rounded_vector<Real>(axis);
      testing::expect_unit_vectors_in_the_support(PowerCosineLobe<Real>(about, rounded<Real>(exponent)));
      testing::expect_inverses_in_the_square(PowerCosineLobe<Real>(about, rounded<Real>(exponent)));
    }
  }
}

TEST(PowerCosineLobe, GivesUnitVectorsInItsSupportAtTheEdgesOfTheSquare) {
  expect_edges<double>();
  expect_edges<float>();
  expect_edges<Packet>();
}

// For exponents below 1, rounding may move the outermost draws beyond 90 degrees. Their density is
// then 0, and never NaN.
TEST(PowerCosineLobe, IsFiniteAtTheEdgesForSmallExponents) {
  for (float exponent : {0.0f, 1e-3f, 0.5f}) {
    for (const Vec2<float>& u : testing::edge_points<float>()) {
      const PowerCosineLobe<float> lobe(tilted.cast<float>(), exponent);
      const float density = lobe.pdf(lobe.sample(u)).value();
      EXPECT_TRUE(density >= 0 && density < 1) << density;
      EXPECT_TRUE(lobe.invert(lobe.sample(u)).allFinite());
    }
  }
}

RC_GTEST_PROP(PowerCosineLobe, HasTheJacobianOneOverItsDensity, ()) {
  testing::check_jacobian(PowerCosineLobe<double>(tilted, any_exponent()));
}

// A direction has an error of a few ulp, which is large relative to a lobe's angle of 1/sqrt(n).
RC_GTEST_PROP(PowerCosineLobe, IsInvertedByItsInverse, ()) {
  const double exponent = any_exponent();
  testing::check_round_trip(PowerCosineLobe<double>(tilted, exponent), 1e-14 * std::sqrt(1 + exponent));
}

// The density of a packet at its own draws agrees with double there, for any exponent.
TEST(PowerCosineLobe, IsTheSameInPackets) {
  for (double exponent : {0.0, 5.0, 100.0}) {
    testing::expect_packets_agree(
        [=]<class Real>(std::type_identity<Real>) {
          return PowerCosineLobe<Real>({Real(0), Real(0), Real(1)}, rounded<Real>(exponent));
        },
        5e-6);
  }
}

TEST(PowerCosineLobe, RefusesAnExponentThatIsNone) {
  EXPECT_THROW(PowerCosineLobe<double>(tilted, -0.1), std::invalid_argument);
  EXPECT_THROW(PowerCosineLobe<double>(tilted, INFINITY), std::invalid_argument);
  EXPECT_THROW(PowerCosineLobe<float>({0, 0, 1}, 1.1e8f), std::invalid_argument);
  EXPECT_NO_THROW(PowerCosineLobe<float>({0, 0, 1}, 1e8f));
  EXPECT_THROW(PowerCosineLobe<double>(tilted, std::nan("")), std::invalid_argument);
}

TEST(PowerCosineLobe, RefusesAnAxisThatIsNoUnitVector) {
  EXPECT_THROW(PowerCosineLobe<double>({0, 0, 2}, 1), std::invalid_argument);
  EXPECT_THROW(PowerCosineLobe<Packet>({Packet(0), Packet(0), Packet(0.5f)}, Packet(1)), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

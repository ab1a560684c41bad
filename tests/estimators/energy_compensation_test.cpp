#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/microfacets.h>

#include <fairlight/estimators/energy_compensation.h>

namespace fairlight {
namespace {

using testing::direction_above;
using testing::roughness;
using testing::unit_number;
using testing::unit_point;

static_assert(Bsdf<EnergyCompensatedConductor<double>>);
static_assert(Bsdf<EnergyCompensatedConductor<Packet, SchlickReflectance<Packet>>>);

const Vec3<double> up(0, 0, 1);
const Rgb<double> gold(1, 0.75, 0.25);

template <class Real = double>
EnergyCompensatedConductor<Real> metal(double alpha, const Rgb<double>& colour = gold) {
  return EnergyCompensatedConductor<Real>(alpha, ConstantReflectance<Real>(colour.cast<Real>()));
}

// At alpha = 1 the loss is z log(1 + 1/z), and its mean is 1 - 4/3 (1 - log 2).
TEST(GgxLoss, IsAClosedFormAtRoughnessOne) {
  const GgxLoss loss(1);
  for (double z : {1.0, 0.7, 0.3, 0.1, 0.01, 1e-4}) {
    EXPECT_NEAR(ggx_loss(1, z), z * std::log1p(1 / z), 1e-8) << z;
    EXPECT_NEAR(loss(z), z * std::log1p(1 / z), 1e-5) << z;
    EXPECT_NEAR(static_cast<double>(loss(static_cast<float>(z))), loss(z), 1e-6) << z;
  }
  EXPECT_NEAR(loss.mean(), 1 - 4.0 / 3 * (1 - M_LN2), 1e-5);
}

TEST(GgxLoss, IsNothingAtTheHorizon) { EXPECT_LE(GgxLoss(0.5)(0.0), 1e-6); }

// Far from grazing angles, the loss of a smooth surface is alpha^2 (1 + z^2) / (2 z^2).
TEST(GgxLoss, FallsWithTheSquareOfTheRoughness) {
  EXPECT_NEAR(ggx_loss(1e-3, 1) / 1e-6, 1, 2e-3);
  EXPECT_NEAR(ggx_loss(1e-3, 0.5) / 2.5e-6, 1, 2e-3);
}

RC_GTEST_PROP(GgxLoss, FitsTheQuadrature, ()) {
  const double alpha = *roughness();
  const GgxLoss loss(alpha);
  for (double z : {(*direction_above()).z(), (*direction_above()).z(), *unit_number()}) {
    RC_ASSERT(loss(z) >= 0 && loss(z) < 0.7);
    if (z < 1e-10) continue;  // the quadrature has no value there
    RC_ASSERT(std::abs(loss(z) - ggx_loss(alpha, z)) <= 1e-5);
  }
}

// At alpha = 1 and z = 1 the loss is log 2 = 0.69, and its mean is 0.59: f_ms = log(2)^2 / (pi
// 0.59).
TEST(EnergyCompensatedConductor, AddsWhatASingleReflectionLoses) {
  const Rgb<double> white = Rgb<double>::Constant(1);
  const double once = 1 / (4 * M_PI);
  const double further = M_LN2 * M_LN2 / (M_PI * (1 - 4.0 / 3 * (1 - M_LN2)));
  EXPECT_TRUE(metal(1, white).eval(up, up).isApprox((once + further) * white, 1e-5));
}

TEST(EnergyCompensatedConductor, AddsLittleToADarkMetal) {
  const RoughConductor<double> once(Ggx<double>(0.5, 0.5), ConstantReflectance<double>(gold));
  const Rgb<double> added = metal(0.5).eval(up, up) - once.eval(up, up);
  EXPECT_LT(added[2], added[0] / 16);  // the blue F^2 is at most 1/16
  EXPECT_GT(added[2], 0);
}

// White facets return all light. Coloured ones return F E + C (1 - E), which has a closed form at
// alpha = 1.
TEST(EnergyCompensatedConductor, ReflectsWhatItsFacetsDoNotAbsorb) {
  const double once = 1 - 0.6 * std::log1p(1 / 0.6);
  const double leaving = 4.0 / 3 * (1 - M_LN2);
  const Rgb<double> further = gold.square() * leaving / (1 - gold * (1 - leaving));
  EXPECT_TRUE(metal(1).albedo({0, 0.8, 0.6}).isApprox(gold * once + further * (1 - once), 1e-5));
}

RC_GTEST_PROP(EnergyCompensatedConductor, ReflectsAllOfItWhenItsFacetsAreWhite, ()) {
  const double alpha = *roughness();
  const Vec3<double> out = *direction_above();
  const Rgb<double> reflected = metal(alpha).albedo(out);
  RC_ASSERT(std::abs(reflected[0] - 1) <= 1e-5);
  RC_ASSERT((reflected > 0).all() && (reflected <= 1 + 1e-5).all());
  const Rgb<Packet> packets = metal<Packet>(alpha).albedo(out.cast<float>().cast<Packet>());
  for (int c = 0; c < 3; ++c) {
    for (double lane : testing::lanes_of(packets[c])) RC_ASSERT(std::abs(lane - reflected[c]) <= 3e-6);
  }
}

TEST(EnergyCompensatedConductor, IsBlackFromBelow) {
  const auto surface = metal(0.5);
  EXPECT_TRUE((surface.albedo({0.6, 0, -0.8}) == 0).all());
  const Vec3<double> below(0.6, 0, -0.8);
  for (const auto& [out, in] : {std::pair(up, below), std::pair(below, up), std::pair(up, Vec3<double>(-up))}) {
    EXPECT_TRUE((surface.eval(out, in) == 0).all());
    EXPECT_EQ(surface.pdf(out, in).value(), 0);
  }
  EXPECT_TRUE((surface.sample(below, {0.5, 0.5, 0}).weight == 0).all());
}

TEST(EnergyCompensatedConductor, RefusesARoughnessOutsideItsDomain) {
  EXPECT_THROW(metal(0), std::invalid_argument);
  EXPECT_THROW(metal(1.5), std::invalid_argument);
  EXPECT_THROW(metal(std::nan("")), std::invalid_argument);
  EXPECT_THROW(GgxLoss(0), std::invalid_argument);
}

RC_GTEST_PROP(EnergyCompensatedConductor, IsReciprocal, ()) {
  const auto surface = metal(*roughness());
  const Vec3<double> out = *direction_above(), in = *direction_above();
  RC_ASSERT(surface.eval(out, in).isApprox(surface.eval(in, out), 1e-14));
}

template <class Real>
void expect_bounce(const EnergyCompensatedConductor<Real>& surface, const Vec3<Real>& out, const Vec3<Real>& u) {
  const Bounce<Real> bounce = surface.sample(out, u);
  const Real p = bounce.density.value();
  RC_ASSERT(std::abs(bounce.in.norm() - 1) <= 8 * ulp<Real>);
  RC_ASSERT(std::isfinite(p) && (p > 0) == (out.z() > 0 && bounce.in.z() > 0));
  RC_ASSERT(p == surface.pdf(out, bounce.in).value());
  RC_ASSERT(bounce.weight.isFinite().all() && (bounce.weight >= 0).all());
  const Rgb<Real> light = surface.eval(out, bounce.in) * bounce.in.z();
  RC_ASSERT(((bounce.weight * p - light).abs() <= 4 * ulp<Real> * light).all() || p == 0);
}

RC_GTEST_PROP(EnergyCompensatedConductor, WeighsABounceByReflectanceCosineAndDensity, ()) {
  const auto surface = metal(*roughness());
  const Vec3<double> out = *direction_above();
  const Vec2<double> u = *unit_point();
  expect_bounce(surface, out, {u.x(), u.y(), *unit_number()});
  for (const Vec2<double>& edge : testing::edge_points()) {
    for (double choice : {0.0, 1 - 0x1p-53}) expect_bounce(surface, out, {edge.x(), edge.y(), choice});
  }
}

RC_GTEST_PROP(EnergyCompensatedConductor, WeighsABounceInFloats, ()) {
  const auto surface = metal<float>(*roughness());
  const Vec3<float> out = (*direction_above()).cast<float>();
  for (const Vec2<float>& edge : testing::edge_points_float()) {
    for (float choice : {0.0f, 1 - 0x1p-24f}) expect_bounce(surface, out, {edge.x(), edge.y(), choice});
  }
}

TEST(EnergyCompensatedConductor, IsTheSameInPackets) {
  const Vec3<double> out(0.48, 0.64, 0.6);
  const auto surface = metal(0.5);
  const auto packets = metal<Packet>(0.5);
  for (const Vec3<double>& u : {Vec3<double>(0.25, 0.5, 0), Vec3<double>(0.875, 0.0625, 0.75)}) {
    const Bounce<double> bounce = surface.sample(out, u);
    const Bounce<Packet> lanes = packets.sample(out.cast<Packet>(), u.cast<Packet>());
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(static_cast<double>(lanes.in[c].get(0)), bounce.in[c], 5e-7);
      EXPECT_NEAR(static_cast<double>(lanes.weight[c].get(0)), bounce.weight[c], 5e-6);
    }
  }
}

}  // namespace
}  // namespace fairlight

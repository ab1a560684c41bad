#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/microfacets.h>

#include <fairlight/estimators/rough_conductor.h>

namespace fairlight {
namespace {

using testing::direction_above;
using testing::roughness;
using testing::unit_point;

static_assert(Bsdf<RoughConductor<double>>);
static_assert(Bsdf<RoughConductor<float, SchlickReflectance<float>>>);
static_assert(Bsdf<RoughConductor<Packet>>);

const Vec3<double> up(0, 0, 1);
const Rgb<double> gold(1, 0.75, 0.25);

template <class Real = double>
RoughConductor<Real> conductor(double alpha_x, double alpha_y, const Rgb<double>& colour = gold) {
  return RoughConductor<Real>(Ggx<Real>(rounded<Real>(alpha_x), rounded<Real>(alpha_y)),
                              ConstantReflectance<Real>(colour.cast<Real>()));
}

TEST(ConstantReflectance, RefusesWhatNoSurfaceReflects) {
  EXPECT_THROW(ConstantReflectance<double>({0.5, 1.1, 0.5}), std::invalid_argument);
  EXPECT_THROW(ConstantReflectance<double>({0.5, 0.5, -0.1}), std::invalid_argument);
  EXPECT_THROW(SchlickReflectance<double>({std::nan(""), 0.5, 0.5}), std::invalid_argument);
  EXPECT_THROW(SchlickReflectance<double>({0.5, 0.5, 1.1}), std::invalid_argument);
}

TEST(FresnelReflectance, IsThatOfASmoothConductor) {
  const Rgb<double> eta(0.2, 0.9, 1.5), k(3.9, 2.5, 1.9);
  const FresnelReflectance<double> reflectance(eta, k);
  EXPECT_TRUE((reflectance(0.5) == fresnel_conductor(0.5, eta, k)).all());
  // At normal incidence F = ((eta - 1)^2 + k^2) / ((eta + 1)^2 + k^2).
  EXPECT_NEAR(reflectance(1)[0], (0.64 + 15.21) / (1.44 + 15.21), 1e-14);
}

TEST(FresnelReflectance, RefusesAnIndexThatIsNone) {
  const Rgb<double> eta(0.2, 0.9, 1.1);
  for (double wrong : {0.0, -1.0, infinity<double>, std::nan("")}) {
    EXPECT_THROW(FresnelReflectance<double>(Rgb<double>(1, wrong, 1), eta), std::invalid_argument) << wrong;
  }
  for (double wrong : {-1e-9, infinity<double>, std::nan("")}) {
    EXPECT_THROW(FresnelReflectance<double>(eta, Rgb<double>(1, 1, wrong)), std::invalid_argument) << wrong;
  }
}

TEST(SchlickReflectance, RisesFromNormalToWhite) {
  const SchlickReflectance<double> reflectance(gold);
  EXPECT_TRUE(reflectance(1).isApprox(gold, 1e-15));
  EXPECT_TRUE(reflectance(0.5).isApprox(gold + (1 - gold) / 32, 1e-15));
  EXPECT_TRUE(reflectance(0).isApprox(Rgb<double>::Constant(1), 1e-15));
}

// D = 4 / pi, without masking: f = F D / 4.
TEST(RoughConductor, ReflectsFromItsFlatFacets) {
  EXPECT_TRUE(conductor(0.5, 0.5).eval(up, up).isApprox(gold / M_PI, 1e-15));
  EXPECT_DOUBLE_EQ(conductor(0.5, 0.5).pdf(up, up).value(), 1 / M_PI);
}

// D = 1 / pi everywhere: f = F / (2 pi (z_out + z_in)).
TEST(RoughConductor, IsSimpleAtRoughnessOne) {
  const Vec3<double> out(0.6, 0, 0.8), in(0, 0.8, 0.6);
  EXPECT_TRUE(conductor(1, 1).eval(out, in).isApprox(gold / (2 * M_PI * 1.4), 1e-15));
}

// The integral of z_in / (z_out + z_in) over z_in.
TEST(RoughConductor, ReflectsAClosedFormAtRoughnessOne) {
  for (double z : {1.0, 0.6, 0.1, 1e-3, 1e-6}) {
    const Vec3<double> out(0, std::sqrt((1 - z) * (1 + z)), z);
    EXPECT_TRUE(conductor(1, 1).albedo(out).isApprox(gold * (1 - z * std::log1p(1 / z)), 2e-6)) << z;
  }
}

TEST(RoughConductor, IsAMirrorWhenItIsSmooth) {
  EXPECT_TRUE(conductor(1e-4, 1e-4).albedo({0.6, 0, 0.8}).isApprox(gold, 1e-7));
  const RoughConductor<double, SchlickReflectance<double>> varnish({1e-4, 1e-4}, SchlickReflectance<double>(gold));
  EXPECT_TRUE(varnish.albedo({0, 0.6, 0.8}).isApprox(SchlickReflectance<double>(gold)(0.8), 1e-7));
}

// In double to the stated accuracy; in packets a few ulp more.
RC_GTEST_PROP(RoughConductor, ReflectsNoMoreThanItsFacets, ()) {
  const double alpha_x = *roughness(), alpha_y = *roughness();
  const Vec3<double> out = *direction_above();
  const Rgb<double> reflected = conductor(alpha_x, alpha_y).albedo(out);
  RC_ASSERT((reflected > 0).all() && (reflected <= gold * (1 + 2e-6)).all());
  const Rgb<Packet> packets = conductor<Packet>(alpha_x, alpha_y).albedo(out.cast<float>().cast<Packet>());
  for (int c = 0; c < 3; ++c) {
    for (double lane : testing::lanes_of(packets[c])) RC_ASSERT(std::abs(lane - reflected[c]) <= 3e-6);
  }
}

// Swapping the axes, or mirroring the direction, changes nothing.
RC_GTEST_PROP(RoughConductor, ReflectsAlikeBySymmetry, ()) {
  const double alpha_x = *roughness(), alpha_y = *roughness();
  const Vec3<double> out = *direction_above();
  const Rgb<double> reflected = conductor(alpha_x, alpha_y).albedo(out);
  RC_ASSERT(conductor(alpha_y, alpha_x).albedo({out.y(), out.x(), out.z()}).isApprox(reflected, 1e-13));
  RC_ASSERT(conductor(alpha_x, alpha_y).albedo({-out.x(), out.y(), out.z()}).isApprox(reflected, 1e-13));
}

TEST(RoughConductor, IsBlackFromBelow) {
  const auto surface = conductor(0.5, 0.5);
  EXPECT_TRUE((surface.albedo({0.6, 0, -0.8}) == 0).all());
  const Vec3<double> below(0.6, 0, -0.8);
  for (const auto& [out, in] : {std::pair(up, below), std::pair(below, up), std::pair(up, Vec3<double>(-up))}) {
    EXPECT_TRUE((surface.eval(out, in) == 0).all());
    EXPECT_EQ(surface.pdf(out, in).value(), 0);
  }
  EXPECT_TRUE((surface.sample(below, {0.5, 0.5}).weight == 0).all());
  EXPECT_EQ(surface.sample(below, {0.5, 0.5}).density.value(), 0);
}

RC_GTEST_PROP(RoughConductor, IsReciprocal, ()) {
  const RoughConductor<double, SchlickReflectance<double>> surface({*roughness(), *roughness()},
                                                                   SchlickReflectance<double>(gold));
  const Vec3<double> out = *direction_above(), in = *direction_above();
  RC_ASSERT(surface.eval(out, in).isApprox(surface.eval(in, out), 1e-14));
}

template <class Real>
void expect_bounce(const RoughConductor<Real>& surface, const Vec3<Real>& out, const Vec2<Real>& u) {
  const Bounce<Real> bounce = surface.sample(out, u);
  RC_ASSERT(std::abs(bounce.in.norm() - 1) <= 8 * ulp<Real>);
  RC_ASSERT((bounce.weight >= 0).all() && (bounce.weight <= 1 + 8 * ulp<Real>).all());
  RC_ASSERT(std::isfinite(bounce.density.value()));
  RC_ASSERT((bounce.density.value() > 0) == (out.z() > 0 && bounce.in.z() > 0));
}

RC_GTEST_PROP(RoughConductor, WeighsABounceBetweenZeroAndOne, ()) {
  const auto surface = conductor(*roughness(), *roughness());
  const Vec3<double> out = *direction_above();
  expect_bounce(surface, out, *unit_point());
  for (const Vec2<double>& u : testing::edge_points()) expect_bounce(surface, out, u);
}

RC_GTEST_PROP(RoughConductor, WeighsABounceBetweenZeroAndOneInFloats, ()) {
  const auto surface = conductor<float>(*roughness(), *roughness());
  const Vec3<float> out = (*direction_above()).cast<float>();
  expect_bounce(surface, out, *testing::unit_point_float());
  for (const Vec2<float>& u : testing::edge_points_float()) expect_bounce(surface, out, u);
}

// A bounce's weight times its density is f cos, and its density agrees with `pdf`. D depends on the
// fourth power of the normal over the roughness. The normal has an error of an ulp or two over the
// length of out + in; cos(in) has a relative error of an ulp or two over cos(in).
template <class Real>
void expect_consistent(double alpha, const Vec3<double>& direction, const Vec2<Real>& u) {
  const auto surface = conductor<Real>(alpha, alpha);
  const Vec3<Real> out = direction.cast<Real>();
  const Bounce<Real> bounce = surface.sample(out, u);
  const Real p = surface.pdf(out, bounce.in).value();
  const double length = static_cast<double>((out + bounce.in).norm());
  const double tolerance = 40 * static_cast<double>(ulp<Real>) / (alpha * std::min(length, 1.0));
  RC_PRE(tolerance < 0.1);
  RC_ASSERT(std::abs(static_cast<double>(p - bounce.density.value())) <= tolerance * static_cast<double>(p));
  const Rgb<Real> light = surface.eval(out, bounce.in) * bounce.in.z();
  for (int c = 0; c < 3; ++c) {
    const Real weighed = bounce.weight[c] * bounce.density.value();
    RC_ASSERT(static_cast<double>(std::abs(weighed - light[c])) <= tolerance * static_cast<double>(light[c]));
  }
}

RC_GTEST_PROP(RoughConductor, WeighsABounceByReflectanceCosineAndDensity, ()) {
  expect_consistent<double>(*roughness(), *direction_above(), *unit_point());
}

RC_GTEST_PROP(RoughConductor, WeighsABounceByReflectanceCosineAndDensityInFloats, ()) {
  expect_consistent<float>(*roughness(), *direction_above(), *testing::unit_point_float());
}

TEST(RoughConductor, IsTheSameInPackets) {
  const Vec3<double> out(0.48, 0.64, 0.6);
  const auto surface = conductor(0.5, 0.125);
  const auto packets = conductor<Packet>(0.5, 0.125);
  for (const Vec2<double>& u : {Vec2<double>(0, 0), Vec2<double>(0.25, 0.5), Vec2<double>(0.875, 0.0625)}) {
    const Bounce<double> bounce = surface.sample(out, u);
    const Bounce<Packet> lanes = packets.sample(out.cast<Packet>(), u.cast<Packet>());
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(static_cast<double>(lanes.in[c].get(0)), bounce.in[c], 5e-7);
      EXPECT_NEAR(static_cast<double>(lanes.weight[c].get(0)), bounce.weight[c], 2e-6);
    }
    EXPECT_NEAR(static_cast<double>(lanes.density.value().get(0)), bounce.density.value(),
                5e-6 * bounce.density.value());
  }
}

// At roughness 1, D = 1 / pi: f = F / (2 pi (z_out + z_in)), and p = D / (2 (z + s)) with s = 1.
// From opposite sides the sum of the directions has the length 2 z, whose square underflows in
// floats; for 1e-280 it is 0 in double.
template <class Real>
void expect_grazing_facets(Real z) {
  const auto surface = conductor<Real>(1, 1);
  for (const Vec3<Real>& in : {Vec3<Real>(-1, 0, z), Vec3<Real>(1, 0, z), Vec3<Real>(0, 1, z)}) {
    const Rgb<Real> f = surface.eval({1, 0, z}, in);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(static_cast<double>(f[c] * z) / (gold[c] / (4 * M_PI)), 1, 8 * static_cast<double>(ulp<Real>));
    }
    const auto p = static_cast<double>(surface.pdf({1, 0, z}, in).value());
    EXPECT_NEAR(p * 2 * M_PI, 1, 8 * static_cast<double>(ulp<Real>));
  }
}

TEST(RoughConductor, ReflectsAClosedFormAtGrazingAngles) {
  for (float z : {1.1e-27f, 1e-25f, 1e-20f, 1e-15f, 1e-10f}) expect_grazing_facets<float>(z);
  for (double z : {1.1e-290, 1e-200, 1e-150, 1e-20}) expect_grazing_facets<double>(z);
}

TEST(RoughConductor, HasNumbersAtAnyHeightInFloats) {
  for (float alpha : {1e-4f, 1e-2f, 1.0f}) {
    const RoughConductor<float> surface({alpha < 1e-3f ? std::nextafter(1e-4f, 1.0f) : alpha, 1},
                                        ConstantReflectance<float>(Rgb<float>::Ones()));
    for (int i = -45; i < 0; ++i) {
      const auto z = static_cast<float>(std::pow(10.0, i));
      const Vec3<float> out(std::sqrt(1 - z * z), 0, z);
      for (int j = -45; j < 0; ++j) {
        const auto height = static_cast<float>(std::pow(10.0, j));
        const Vec3<float> in(-std::sqrt(1 - height * height), 0, height);
        EXPECT_TRUE(surface.eval(out, in).isFinite().all()) << z << ' ' << height;
        EXPECT_EQ((surface.eval(out, in) > 0).all(), std::min(i, j) >= -27) << z << ' ' << height;
        EXPECT_EQ(surface.pdf(out, in).value() > 0, std::min(i, j) >= -27) << z << ' ' << height;
      }
      for (const Vec2<float>& u : testing::edge_points_float()) {
        const auto bounce = surface.sample(out, u);
        EXPECT_TRUE((bounce.weight >= 0).all() && (bounce.weight <= 1 + 8 * ulp<float>).all()) << z;
        EXPECT_TRUE(std::isfinite(bounce.density.value())) << z;
      }
    }
  }
}

TEST(RoughConductor, RefusesAnAlbedoAtHeightsBelowThoseThatItKnows) {
  const auto along = [](double z) { return Vec3<double>(std::sqrt((1 - z) * (1 + z)), 0, z); };
  EXPECT_NO_THROW(conductor(0.5, 0.5).albedo(along(1e-10)));
  EXPECT_THROW(conductor(0.5, 0.5).albedo(along(0.9e-10)), std::invalid_argument);
  EXPECT_NO_THROW(conductor<float>(0.5, 0.5).albedo(along(1e-6).cast<float>()));
  EXPECT_THROW(conductor<float>(0.5, 0.5).albedo(along(0.9e-6).cast<float>()), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/materials.h>

#include <fairlight/estimators/glossy.h>
#include <fairlight/estimators/hemisphere.h>

namespace fairlight {
namespace {

using testing::edge_points;

static_assert(Bsdf<Glossy<double>>);
static_assert(Bsdf<Glossy<double, CosineHemisphere>>);
static_assert(Bsdf<Glossy<Packet>>);

const Rgb<double> albedo(0.75, 0.5, 0.25);

// A direction to the viewer, with z from 1 down to 1e-9.
Vec3<double> any_out() {
  const double z = std::pow(10.0, -9 * *testing::unit_number());
  const double phi = 2 * M_PI * *testing::unit_number();
  const double radius = std::sqrt((1 - z) * (1 + z));
  return {radius * std::cos(phi), radius * std::sin(phi), z};
}
double any_exponent() { return std::pow(10.0, 6 * *testing::unit_number()); }

TEST(Glossy, IsALobeAboutTheMirrorDirection) {
  const Glossy<double> surface(albedo, 2);
  const Vec3<double> out(0.6, 0, 0.8);
  EXPECT_TRUE(surface.eval(out, {-0.6, 0, 0.8}).isApprox(albedo * 2 / M_PI));
  EXPECT_TRUE(surface.eval(out, {0, 0, 1}).isApprox(albedo * 2 / M_PI * 0.64));
  EXPECT_DOUBLE_EQ(surface.pdf(out, {0, 0, 1}).value(), 1.5 / M_PI * 0.64);
  EXPECT_TRUE((surface.eval(out, {0.96, 0, 0.28}) == 0).all());
}

TEST(Glossy, OfExponentZeroSeenFromAboveIsDiffuse) {
  EXPECT_TRUE(Glossy<double>(albedo, 0).eval({0, 0, 1}, {0, 0.8, 0.6}).isApprox(albedo / M_PI));
}

TEST(Glossy, IsBlackBelowTheSurface) {
  const Glossy<double> surface(albedo, 2);
  EXPECT_TRUE((surface.eval({0.6, 0, 0.8}, {-0.8, 0, -0.6}) == 0).all());
  EXPECT_TRUE((surface.eval({0.6, 0, -0.8}, {-0.6, 0, 0.8}) == 0).all());
}

// cos(alpha)^3 = 0.008 on the side away from the normal: below the surface, as the viewer is at 70
// degrees.
TEST(Glossy, AbsorbsWhatItDrawsBelowTheSurface) {
  const Vec3<double> out(std::sin(1.2), 0, std::cos(1.2));
  for (double turn : {0.0, 0.25, 0.5, 0.75}) {
    const auto bounce = Glossy<double>(albedo, 2).sample(out, {0.992, turn});
    EXPECT_GT(bounce.density.value(), 0);
    EXPECT_EQ((bounce.weight == 0).all(), bounce.in.z() <= 0);
  }
}

TEST(Glossy, ReflectsItsAlbedoOfWhatComesStraightOn) {
  for (double exponent : {0.0, 0.5, 5.0, 1e4, 1e8}) {
    EXPECT_TRUE(Glossy<double>(albedo, exponent).albedo({0, 0, 1}).isApprox(albedo, 1e-15)) << exponent;
  }
  EXPECT_TRUE((Glossy<double>(albedo, 5).albedo({0.6, 0, -0.8}) == 0).all());
}

// n = 0: the part of the hemisphere above the surface, (1 + z) / 2. n = 1: z (1 - theta / pi +
// sin(2 theta) / (2 pi)) + sin^3(theta) / pi.
TEST(Glossy, ReflectsLessFromTheSide) {
  EXPECT_TRUE(Glossy<double>(albedo, 0).albedo({0.6, 0, 0.8}).isApprox(albedo * 0.9, 1e-11));
  const double theta = std::asin(0.6);
  const double seen = 0.8 * (1 - theta / M_PI + 0.48 / M_PI) + 0.216 / M_PI;
  EXPECT_TRUE(Glossy<double>(albedo, 1).albedo({0, 0.6, 0.8}).isApprox(albedo * seen, 1e-11));
}

TEST(Glossy, OfAHighExponentReflectsTheCosine) {
  for (double z : {0.9, 0.5, 0.01}) {
    const Vec3<double> out(std::sqrt((1 - z) * (1 + z)), 0, z);
    EXPECT_TRUE(Glossy<double>(albedo, 1e8).albedo(out).isApprox(albedo * z, 1e-11)) << z;
  }
}

RC_GTEST_PROP(Glossy, ReflectsNoMoreThanItsAlbedo, ()) {
  const double exponent = *rc::gen::element(0.0, 0.1, 1.0) + any_exponent() - 1;
  const Vec3<double> out = any_out();
  const Rgb<double> reflected = Glossy<double>(albedo, exponent).albedo(out);
  RC_ASSERT((reflected > 0).all() && (reflected <= albedo * (1 + 8 * ulp<double>)).all());
  const Rgb<Packet> packets = Glossy<Packet>(albedo.cast<float>().cast<Packet>(), rounded<Packet>(exponent))
                                  .albedo(out.cast<float>().cast<Packet>());
  for (int c = 0; c < 3; ++c) {
    for (double lane : testing::lanes_of(packets[c])) RC_ASSERT(std::abs(lane / reflected[c] - 1) <= 2e-6);
  }
}

template <class Surface>
void check_bounce(const Surface& surface, const Vec3<double>& out, const Vec2<double>& u) {
  const auto bounce = surface.sample(out, u);
  RC_ASSERT(bounce.density.value() == surface.pdf(out, bounce.in).value());
  RC_ASSERT(bounce.weight.allFinite() && (bounce.weight >= 0).all());
  const Rgb<double> expected = surface.eval(out, bounce.in) * bounce.in.z() / bounce.density.value();
  constexpr double denormal = 1e-300;  // far from a sharp lobe, where digits are lost
  RC_ASSERT((bounce.weight - expected).abs().maxCoeff() <= 1e-15 * expected.maxCoeff() + denormal);
}

RC_GTEST_PROP(Glossy, WeighsABounceByItsIntegrandOverItsDensity, ()) {
  const double exponent = any_exponent();
  const Vec3<double> out = any_out();
  for (const Vec2<double>& u : edge_points()) {
    check_bounce(Glossy<double>(albedo, exponent), out, u);
    check_bounce(Glossy<double, CosineHemisphere>(albedo, exponent), out, u);
  }
}

// Sampled by the lobe, a bounce weighs albedo (n + 2) / (n + 1) cos(in), for any exponent and
// angle.
RC_GTEST_PROP(Glossy, WeighsALobesBounceByTheCosine, ()) {
  const double exponent = any_exponent();
  const auto bounce = Glossy<double>(albedo, exponent).sample(any_out(), *testing::unit_point());
  const Rgb<double> expected = albedo * ((exponent + 2) / (exponent + 1) * std::max(bounce.in.z(), 0.0));
  RC_ASSERT((bounce.weight - expected).abs().maxCoeff() <= 1e-14);
}

RC_GTEST_PROP(Glossy, IsReciprocal, ()) {
  const Glossy<double> surface(albedo, *rc::gen::element(0.0, 1.0, 20.0, 300.0));
  const Vec3<double> a = any_out();
  const Vec3<double> b = any_out();
  RC_ASSERT(surface.eval(a, b).isApprox(surface.eval(b, a), 1e-10));
}

TEST(Glossy, BouncesInPacketsAsInDouble) {
  for (double turn : {0.0, 0.125, 0.6, 0.9}) {
    for (double x : {0.1, 0.5, 0.75}) {
      const auto expected = Glossy<double>(albedo, 50).sample({0.6, 0, 0.8}, {x, turn});
      const auto bounce =
          Glossy<Packet>(albedo.cast<float>().cast<Packet>(), Packet(50))
              .sample({Packet(0.6f), Packet(0), Packet(0.8f)}, {rounded<Packet>(x), rounded<Packet>(turn)});
      for (int i = 0; i < 3; ++i) {
        EXPECT_LE(std::abs(static_cast<double>(bounce.in[i].get(0)) - expected.in[i]), 1e-6);
        EXPECT_LE(std::abs(static_cast<double>(bounce.weight[i].get(0)) - expected.weight[i]), 2e-6);
      }
      EXPECT_LE(std::abs(static_cast<double>(bounce.density.value().get(0)) / expected.density.value() - 1), 2e-5);
    }
  }
}

TEST(Glossy, RefusesAnAlbedoOrAnExponentThatIsNone) {
  EXPECT_THROW(Glossy<double>(Rgb<double>(1.1, 0, 0), 5), std::invalid_argument);
  EXPECT_THROW(Glossy<double>(Rgb<double>(0, -0.1, 0), 5), std::invalid_argument);
  EXPECT_THROW(Glossy<double>(Rgb<double>(0, 0, std::nan("")), 5), std::invalid_argument);
  for (double wrong : {-1.0, infinity<double>, std::nan("")}) {
    EXPECT_THROW(Glossy<double>(albedo, wrong), std::invalid_argument) << wrong;
  }
  EXPECT_THROW((Glossy<double, CosineHemisphere>(albedo, -1)), std::invalid_argument);
}

TEST(Glossy, RefusesAnOutgoingDirectionThatIsNoUnitVector) {
  EXPECT_THROW(Glossy<double>(Rgb<double>::Ones(), 5).pdf({0, 0, 2}, {0, 0, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

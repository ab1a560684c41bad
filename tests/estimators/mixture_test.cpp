#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/materials.h>

#include <fairlight/estimators/dielectric.h>
#include <fairlight/estimators/lambertian.h>
#include <fairlight/estimators/mirror.h>
#include <fairlight/estimators/mixture.h>

namespace fairlight {
namespace {

using Diffuse = Lambertian<double>;
using Uniform = Lambertian<double, UniformHemisphere>;
using Glossless = Mixture<Mirror<double>, Diffuse>;
using TwoDiffuse = Mixture<Diffuse, Uniform>;

static_assert(Bsdf<Glossless>);
static_assert(Bsdf<Mixture<Dielectric<Packet>, Mixture<Mirror<Packet>, Lambertian<Packet>>>>);
static_assert(Glossless::dimensions == 3);
static_assert(Mixture<Mirror<double>, Mirror<double>>::dimensions == 1);

const Rgb<double> albedo(0.75, 0.5, 0.25);
const Vec3<double> up(0, 0, 1);
const Mirror<double> mirror{Rgb<double>::Ones()};
const Diffuse diffuse{albedo};
const Glossless varnished(WeightedLobe{mirror, 0.25, 0.5}, WeightedLobe{diffuse, 0.75, 0.5});

TEST(Mixture, AddsWhatItsLobesReflectAndAveragesTheirDensities) {
  const TwoDiffuse surface(WeightedLobe{diffuse, 0.5, 0.25}, WeightedLobe{Uniform(albedo), 0.25, 0.75});
  EXPECT_TRUE(surface.eval(up, {0, 0.8, 0.6}).isApprox(0.75 * albedo / M_PI, 1e-15));
  EXPECT_DOUBLE_EQ(surface.pdf(up, {0, 0.8, 0.6}).value(), 0.25 * 0.6 / M_PI + 0.75 / (2 * M_PI));
  EXPECT_TRUE(surface.albedo(up).isApprox(0.75 * albedo, 1e-15));
}

TEST(Mixture, PaysASingleDirectionWithItsOwnProbability) {
  const auto bounce = varnished.sample({0, 0.8, 0.6}, {0.25, 0.5, 0.5});
  EXPECT_EQ(bounce.in, Vec3<double>(0, -0.8, 0.6));
  EXPECT_TRUE(bounce.weight.isApprox(Rgb<double>::Constant(0.25 / 0.5), 1e-15));
  EXPECT_EQ(bounce.density.value(), 0);
}

TEST(Mixture, PaysADiffuseBounceWithTheDensityOfTheWhole) {
  const auto bounce = varnished.sample({0, 0.8, 0.6}, {0.75, 0.5, 0.5});
  EXPECT_TRUE(bounce.weight.isApprox(0.75 * albedo / 0.5, 1e-15));
  EXPECT_DOUBLE_EQ(bounce.density.value(), 0.5 * bounce.in.z() / M_PI);
}

TEST(Mixture, NestsInMixtures) {
  const Mixture three(WeightedLobe{Dielectric<double>(1.5), 0.5, 0.5}, WeightedLobe{varnished, 0.5, 0.5});
  static_assert(decltype(three)::dimensions == 4);
  const auto reflected = three.sample(up, {0.75, 0.25, 0.5, 0.5});  // the varnish, and in it the mirror
  EXPECT_TRUE(reflected.weight.isApprox(Rgb<double>::Constant(0.5 / 0.5 * 0.25 / 0.5), 1e-15));
  EXPECT_EQ(reflected.density.value(), 0);
  const auto refracted = three.sample(up, {0.25, 0.5, 0.5, 0.5});  // the glass
  EXPECT_EQ(refracted.in, Vec3<double>(0, 0, -1));
  EXPECT_TRUE(refracted.weight.isApprox(Rgb<double>::Constant(1 / 2.25), 1e-15));
}

// Where a density exists, the weight is f cos / p of the whole mixture, whichever lobe the bounce
// came from.
RC_GTEST_PROP(Mixture, WeighsByTheWhole, ()) {
  const double q = *testing::unit_number();
  const TwoDiffuse surface(WeightedLobe{diffuse, q == 0 ? 0 : *testing::unit_number(), q},
                           WeightedLobe{Uniform(Rgb<double>(0.1, 0.2, 1)), 0.5, 1 - q});
  const Vec2<double> u = *testing::unit_point();
  const Vec3<double> out = *testing::direction_above();
  const auto bounce = surface.sample(out, {*testing::unit_number(), u.x(), u.y()});
  const double density = surface.pdf(out, bounce.in).value();
  const Rgb<double> expected = surface.eval(out, bounce.in) * bounce.in.z() / density;
  RC_ASSERT(bounce.density.value() == density);
  RC_ASSERT((bounce.weight - expected).abs().maxCoeff() <= 1e-15 * (1 + expected.maxCoeff()));
}

TEST(Mixture, IsFiniteAtTheEdgesOfTheCubeAndOfItsProbabilities) {
  for (double q : {0.0, 0x1p-53, 0.5, 1 - 0x1p-53, 1.0}) {
    const Glossless surface(WeightedLobe{mirror, q == 0 ? 0 : 0.5, q},
                            WeightedLobe{diffuse, q == 1 ? 0 : 0.5, 1 - q});
    for (const Vec2<double>& u : testing::edge_points()) {
      for (double choice : {0.0, 0x1p-53, 0.5, 1 - 0x1p-53}) {
        const auto bounce = surface.sample(up, {choice, u.x(), u.y()});
        EXPECT_TRUE(bounce.weight.isFinite().all() && (bounce.weight >= 0).all()) << q << ' ' << u.transpose();
        EXPECT_NEAR(bounce.in.norm(), 1, 1e-15);
        EXPECT_EQ(bounce.density.value() == 0, choice < q);
      }
    }
  }
}

TEST(Mixture, WantsProbabilitiesThatSumToOne) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto mix = [](double w1, double q1, double w2, double q2) {
    return Glossless(WeightedLobe{mirror, w1, q1}, WeightedLobe{diffuse, w2, q2});
  };
  EXPECT_NO_THROW(mix(0.5, 0.1, 0.5, 0.9));
  EXPECT_NO_THROW(mix(0, 0, 1, 1));
  EXPECT_THROW(mix(0.5, 0.5, 0.5, 0.4), std::invalid_argument);
  EXPECT_THROW(mix(0.5, 1.5, 0.5, -0.5), std::invalid_argument);
  EXPECT_THROW(mix(0.5, nan, 0.5, 0.5), std::invalid_argument);
  EXPECT_THROW(mix(-0.5, 0.5, 0.5, 0.5), std::invalid_argument);
  EXPECT_THROW(mix(0.5, 0.5, infinity<double>, 0.5), std::invalid_argument);
  EXPECT_THROW(mix(0.5, 0, 0.5, 1), std::invalid_argument);
  EXPECT_THROW(mix(0.5, 1, 0.5, 0), std::invalid_argument);
}

TEST(Mixture, IsTheSameInPackets) {
  const Mirror<Packet> packet_mirror(Rgb<Packet>::Ones());
  const Lambertian<Packet> packet_diffuse(albedo.cast<float>().cast<Packet>());
  const Mixture surface(WeightedLobe{packet_mirror, Packet(0.25f), Packet(0.5f)},
                        WeightedLobe{packet_diffuse, Packet(0.75f), Packet(0.5f)});
  for (double choice : {0.0, 0.49, 0.5, 1 - 0x1p-24}) {
    const Vec3<double> u(choice, 0.25, 0.625);
    const auto exact = varnished.sample({0, 0.8, 0.6}, u);
    const auto bounce = surface.sample({Packet(0), Packet(0.8f), Packet(0.6f)}, u.cast<float>().cast<Packet>());
    for (int i = 0; i < 3; ++i) {
      for (double x : testing::lanes_of(bounce.in[i])) EXPECT_NEAR(x, exact.in[i], 1e-6) << choice;
      for (double w : testing::lanes_of(bounce.weight[i])) EXPECT_NEAR(w, exact.weight[i], 1e-6) << choice;
    }
    for (double p : testing::lanes_of(bounce.density.value())) EXPECT_NEAR(p, exact.density.value(), 1e-6);
  }
}

}  // namespace
}  // namespace fairlight

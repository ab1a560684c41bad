#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/materials.h>

#include <fairlight/estimators/dielectric.h>

namespace fairlight {
namespace {

using Number = Eigen::Matrix<double, 1, 1>;

static_assert(Bsdf<Dielectric<double>>);
static_assert(Bsdf<Dielectric<Packet, Transport::importance>>);

const Dielectric<double> glass(1.5);

// sin i = 0.6, so sin t = 0.4 and cos t = sqrt(0.84).
TEST(Dielectric, RefractsBySnellsLawIntoTheGlass) {
  const auto bounce = glass.sample({0.6, 0, 0.8}, Number(0.999));
  EXPECT_TRUE(bounce.in.isApprox(Vec3<double>(-0.4, 0, -std::sqrt(0.84)), 1e-15));
  EXPECT_TRUE(bounce.weight.isApprox(Rgb<double>::Constant(1 / 2.25), 1e-15));
  EXPECT_EQ(bounce.density.value(), 0);
}

TEST(Dielectric, RefractsBySnellsLawOutOfTheGlass) {
  const auto bounce = glass.sample({0.4, 0, -std::sqrt(0.84)}, Number(0.999));
  EXPECT_TRUE(bounce.in.isApprox(Vec3<double>(-0.6, 0, 0.8), 1e-15));
  EXPECT_TRUE(bounce.weight.isApprox(Rgb<double>::Constant(2.25), 1e-15));
}

TEST(Dielectric, ReflectsWithFresnelsProbability) {
  EXPECT_DOUBLE_EQ(glass.reflectance({0, 0, 1}), 0.04);
  EXPECT_EQ(glass.sample({0, 0, 1}, Number(0.039)).in, Vec3<double>(0, 0, 1));
  EXPECT_EQ(glass.sample({0, 0, 1}, Number(0.041)).in, Vec3<double>(0, 0, -1));
  EXPECT_EQ(glass.sample({0, 0, -1}, Number(0.039)).in, Vec3<double>(0, 0, -1));
  EXPECT_TRUE((glass.sample({0, 0, -1}, Number(0.039)).weight == 1).all());
}

TEST(Dielectric, ReflectsAllBeyondTheCriticalAngle) {
  for (double u : {0.0, 0.5, 1 - 0x1p-53}) {
    const auto bounce = glass.sample({0.8, 0, -0.6}, Number(u));
    EXPECT_EQ(bounce.in, Vec3<double>(-0.8, 0, -0.6));
    EXPECT_TRUE((bounce.weight == 1).all());
  }
}

TEST(Dielectric, DoesNotScaleImportance) {
  const Dielectric<double, Transport::importance> lens(1.5);
  EXPECT_TRUE((lens.sample({0.6, 0, 0.8}, Number(0.999)).weight == 1).all());
  EXPECT_TRUE((lens.albedo({0.6, 0, 0.8}) == 1).all());
}

TEST(Dielectric, WeighsInTheMeanWhatItsAlbedoSays) {
  EXPECT_TRUE(glass.albedo({0, 0, 1}).isApprox(Rgb<double>::Constant(0.04 + 0.96 / 2.25), 1e-15));
  EXPECT_TRUE(glass.albedo({0, 0, -1}).isApprox(Rgb<double>::Constant(0.04 + 0.96 * 2.25), 1e-15));
}

TEST(Dielectric, OfTheIndexOfItsSurroundingsIsNotThere) {
  const Dielectric<double> air(1);
  for (const Vec3<double>& out : {Vec3<double>(0, 0, 1), Vec3<double>(0.6, 0, -0.8), Vec3<double>(1, 0, 0)}) {
    const auto bounce = air.sample(out, Number(0));
    EXPECT_TRUE(bounce.in.isApprox(-out, 1e-15)) << out.transpose();
    EXPECT_TRUE((bounce.weight == 1).all()) << out.transpose();
  }
}

// For every u, a bounce is a unit vector on the right side, and its tangential part obeys Snell's
// law.
RC_GTEST_PROP(Dielectric, BouncesInTheDomain, ()) {
  Vec3<double> out = *testing::direction_above();
  if (*rc::gen::arbitrary<bool>()) out = -out;
  const Dielectric<double> surface(*testing::index_of_refraction());
  const double u = *rc::gen::oneOf(testing::unit_number(), rc::gen::element(0.0, 1 - 0x1p-53));
  const auto bounce = surface.sample(out, Number(u));
  const bool reflected = u < surface.reflectance(out);
  const double eta = reflected ? 1 : surface.eta(out);
  RC_ASSERT(std::abs(bounce.in.norm() - 1) <= 8 * ulp<double> * (1 + 1 / (eta * eta)));
  RC_ASSERT((bounce.in.head<2>() * eta + out.head<2>()).norm() <= 4 * ulp<double>);
  RC_ASSERT((reflected ? bounce.in.z() == out.z() : bounce.in.z() * out.z() <= 0));
  RC_ASSERT((bounce.weight * (eta * eta) - 1).abs().maxCoeff() <= 4 * ulp<double>);
}

// Light takes the same path in both directions: a refracted direction refracts back.
RC_GTEST_PROP(Dielectric, RefractsBackTheWayItCame, ()) {
  const Vec3<double> out = *testing::direction_above();
  const Dielectric<double> surface(1.5);
  const Vec3<double> in = surface.sample(out, Number(1 - 0x1p-53)).in;
  RC_PRE(out.z() > 1e-9);  // closer to the surface almost everything is reflected
  RC_ASSERT(in.z() < 0);
  const Vec3<double> back = surface.sample(in, Number(1 - 0x1p-53)).in;
  // At grazing angles the cosine is the root of a difference, so its square has an error of a few
  // ulp.
  RC_ASSERT((back - out).head<2>().norm() <= 8 * ulp<double>);
  RC_ASSERT(std::abs(back.z() * back.z() - out.z() * out.z()) <= 16 * ulp<double>);
}

TEST(Dielectric, WantsAPositiveFiniteIndex) {
  for (double wrong : {0.0, -1.5, infinity<double>, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(Dielectric<double>{wrong}, std::invalid_argument) << wrong;
  }
}

TEST(Dielectric, IsTheSameInPackets) {
  const Dielectric<Packet> packet_glass(Packet(1.5f));
  for (double z : {1e-6, 0.1, 0.6, 0.8, 1.0, -1e-6, -0.6, -0.8, -1.0}) {
    const Vec3<double> out(0.6 * std::sqrt(1 - z * z), 0.8 * std::sqrt(1 - z * z), z);
    for (double u : {0.0, 0.5, 1 - 0x1p-24}) {
      const auto exact = glass.sample(out, Number(u));
      const auto bounce = packet_glass.sample(out.cast<float>().cast<Packet>(),
                                              Eigen::Matrix<Packet, 1, 1>(Packet(static_cast<float>(u))));
      for (int i = 0; i < 3; ++i) {
        for (double x : testing::lanes_of(bounce.in[i])) EXPECT_NEAR(x, exact.in[i], 1e-6) << z << ' ' << u;
        for (double w : testing::lanes_of(bounce.weight[i])) EXPECT_NEAR(w, exact.weight[i], 1e-6) << z << ' ' << u;
      }
    }
  }
}

// At normal incidence the square of the refracted cosine is a difference that leaves 1e-2, to an
// ulp. So its relative error is 1e2 ulp, and that of the length half as much.
TEST(Dielectric, RefractsToUnitVectorsOverTheWholeRangeOfItsIndex) {
  for (float index : {0.1f, 0.25f, 1.0f, 4.0f, 10.0f}) {
    for (float z : {1.0f, 0.999999f, 0.9999f, -1.0f, -0.999999f, -0.9999f}) {
      const Vec3<float> out(std::sqrt((1 - z) * (1 + z)), 0, z);
      const auto bounce = Dielectric<float>(index).sample(out, Eigen::Matrix<float, 1, 1>(1 - 0x1p-24f));
      EXPECT_LE(std::abs(bounce.in.norm() - 1), 64 * ulp<float>) << index << ' ' << z;
    }
  }
  for (float wrong : {0.09f, 10.1f, 1e-3f, 1e25f})
    EXPECT_THROW(Dielectric<float>{wrong}, std::invalid_argument) << wrong;
}

}  // namespace
}  // namespace fairlight

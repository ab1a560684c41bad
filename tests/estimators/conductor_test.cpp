#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/materials.h>

#include <fairlight/estimators/conductor.h>

namespace fairlight {
namespace {

static_assert(Bsdf<Conductor<double>>);
static_assert(Bsdf<Conductor<Packet>>);

const Rgb<double> eta(1, 2, 1.5);
const Rgb<double> k(2, 3, 0);
const double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Conductor, ReflectsByFresnelAtNormalIncidence) {
  const auto bounce = Conductor<double>(eta, k).sample({0, 0, 1}, {});
  EXPECT_EQ(bounce.in, Vec3<double>(0, 0, 1));
  EXPECT_TRUE(bounce.weight.isApprox(Rgb<double>(0.5, 10.0 / 18, 0.04), 1e-15));  // fresnel_test.cpp
  EXPECT_EQ(bounce.density.value(), 0);
}

TEST(Conductor, HasNoDensityEvenInItsDirection) {
  EXPECT_EQ(Conductor<double>(eta, k).pdf({0, 0.8, 0.6}, {0, -0.8, 0.6}).value(), 0);
  EXPECT_TRUE((Conductor<double>(eta, k).eval({0, 0.8, 0.6}, {0, -0.8, 0.6}) == 0).all());
}

TEST(Conductor, ShowsNothingFromBelow) {
  EXPECT_TRUE((Conductor<double>(eta, k).sample({0, 0.8, -0.6}, {}).weight == 0).all());
}

RC_GTEST_PROP(Conductor, ReflectsNoMoreThanItGets, ()) {
  const Vec3<double> out = *testing::direction_above();
  const Rgb<double> index(*testing::between(0.01, 20), 1, *testing::index_of_refraction());
  const Rgb<double> extinction(*testing::between(0.01, 20), *testing::between(1e-6, 20), 0);
  const auto bounce = Conductor<double>(index, extinction).sample(out, {});
  RC_ASSERT(bounce.in == mirrored(out));
  RC_ASSERT((bounce.weight >= 0).all() && (bounce.weight <= 1 + 4 * ulp<double>).all());
}

TEST(Conductor, WantsAPositiveIndexAndANonnegativeExtinction) {
  for (double wrong : {0.0, -1.0, infinity<double>, nan}) {
    EXPECT_THROW(Conductor<double>(Rgb<double>(1, wrong, 1), k), std::invalid_argument) << wrong;
  }
  for (double wrong : {-1e-9, infinity<double>, nan}) {
    EXPECT_THROW(Conductor<double>(eta, Rgb<double>(1, wrong, 1)), std::invalid_argument) << wrong;
  }
}

TEST(Conductor, IsTheSameInPackets) {
  const Conductor<Packet> metal(eta.cast<float>().cast<Packet>(), k.cast<float>().cast<Packet>());
  for (double z : {1e-6, 0.1, 0.6, 1.0}) {
    const Vec3<double> out(0, std::sqrt((1 - z) * (1 + z)), z);
    const auto exact = Conductor<double>(eta, k).sample(out, {});
    const auto bounce = metal.sample(out.cast<float>().cast<Packet>(), {});
    for (int c = 0; c < 3; ++c) {
      for (double weight : testing::lanes_of(bounce.weight[c])) EXPECT_NEAR(weight, exact.weight[c], 1e-6) << z;
    }
  }
}

// The fourth power of 1e10 overflows in floats. At normal incidence F = ((eta - 1)^2 + k^2) / ((eta
// + 1)^2 + k^2).
TEST(Conductor, WantsAnIndexThatFloatsHold) {
  using Colour = Rgb<float>;
  for (float large : {1e5f, 1e6f}) {
    for (const auto& [n, extinction] : {std::pair(large, large), std::pair(1.0f, large), std::pair(large, 0.0f)}) {
      const Conductor<float> metal(Colour::Constant(n), Colour::Constant(extinction));
      const double less = n - 1, more = n + 1, square = std::pow(static_cast<double>(extinction), 2);
      const double expected = (less * less + square) / (more * more + square);
      EXPECT_NEAR(static_cast<double>(metal.albedo({0, 0, 1})[0]), expected, 4 * static_cast<double>(ulp<float>))
          << large;
      EXPECT_TRUE((metal.albedo({1, 0, 1e-30f}) >= 0).all() && (metal.albedo({1, 0, 1e-30f}) <= 1).all()) << large;
    }
  }
  EXPECT_THROW(Conductor<float>(Colour::Constant(1.1e6f), Colour::Ones()), std::invalid_argument);
  EXPECT_THROW(Conductor<float>(Colour::Ones(), Colour::Constant(1.1e6f)), std::invalid_argument);
  EXPECT_TRUE(std::isnan(fresnel_conductor(0.5f, 1e10f, 1.0f)));
  EXPECT_TRUE(std::isnan(fresnel_dielectric(0.5f, 1e10f)));
}

}  // namespace
}  // namespace fairlight

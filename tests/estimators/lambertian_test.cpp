#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/unit_square.h>

#include <fairlight/estimators/lambertian.h>

namespace fairlight {
namespace {

const Rgb<double> albedo(0.75, 0.5, 0.25);
const Vec3<double> up(0, 0, 1);

static_assert(Bsdf<Lambertian<double>>);
static_assert(Bsdf<Lambertian<Packet, UniformHemisphere>>);

TEST(Lambertian, ReflectsAlbedoOverPi) {
  const Lambertian<double> surface(albedo);
  EXPECT_TRUE(surface.eval(up, {0, 0, 1}).isApprox(albedo / M_PI, 1e-15));
  EXPECT_TRUE(surface.eval(up, {0, 0.8, 0.6}).isApprox(albedo / M_PI, 1e-15));
  EXPECT_TRUE((surface.eval(up, {0, 0.8, -0.6}) == 0).all());
}

TEST(Lambertian, WeighsAUniformBounceTwiceTheCosine) {
  const Lambertian<double, UniformHemisphere> surface(albedo);
  const auto bounce = surface.sample(up, {0.25, 0.5});
  EXPECT_TRUE(bounce.weight.isApprox(albedo * 0.5, 1e-15));
}

template <template <class> class Directions>
void check_weight() {
  EXPECT_TRUE(rc::check([] {
    const Lambertian<double, Directions> surface(albedo);
    const auto bounce = surface.sample(up, *testing::unit_point());
    const Rgb<double> expected = surface.eval(up, bounce.in) * bounce.in.z() / bounce.density.value();
    RC_ASSERT((bounce.weight - expected).abs().maxCoeff() <= 1e-15);
  }));
}

TEST(Lambertian, WeighsABounceByReflectanceCosineAndDensity) {
  check_weight<CosineHemisphere>();
  check_weight<UniformHemisphere>();
}

TEST(Lambertian, GivesFiniteWeightsAtTheEdgesOfTheSquare) {
  for (const Vec2<double>& u : testing::edge_points()) {
    EXPECT_TRUE(Lambertian<double>(albedo).sample(up, u).weight.isApprox(albedo, 1e-15)) << u.transpose();
    const auto uniform = Lambertian<double, UniformHemisphere>(albedo).sample(up, u);
    EXPECT_TRUE((uniform.weight >= 0).all() && (uniform.weight <= 2).all()) << u.transpose();
  }
}

TEST(Lambertian, ReflectsItsAlbedoInAllDirectionsAbove) {
  const Lambertian<double> surface(albedo);
  EXPECT_TRUE((surface.albedo({0, 0.8, 0.6}) == albedo).all());
  EXPECT_TRUE((surface.albedo({0, 0.8, -0.6}) == 0).all());
}

TEST(Lambertian, IsBlackFromBelow) {
  const Lambertian<double> surface(albedo);
  EXPECT_TRUE((surface.eval({0, 0.8, -0.6}, up) == 0).all());
  EXPECT_TRUE((surface.sample({0, 0.8, -0.6}, {0.25, 0.5}).weight == 0).all());
}

TEST(Lambertian, WantsAnAlbedoInZeroToOne) {
  EXPECT_NO_THROW(Lambertian<double>(Rgb<double>(0, 0.5, 1)));
  for (double wrong : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(Lambertian<double>(Rgb<double>(0.5, 0.5, wrong)), std::invalid_argument) << wrong;
    EXPECT_THROW(Lambertian<Packet>(Rgb<Packet>::Constant(Packet(static_cast<float>(wrong)))),
                 std::invalid_argument);
  }
}

// Vectors are not normalised: a vector of length 2 has twice the density, as in the formula.
TEST(Lambertian, TakesDirectionsAsTheyAre) {
  EXPECT_DOUBLE_EQ(Lambertian<double>(albedo).pdf(up, {0, 0, 2}).value(), 2 / M_PI);
}

}  // namespace
}  // namespace fairlight

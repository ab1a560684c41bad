#include <cmath>

#include <gtest/gtest.h>
#include <support/lights.h>
#include <support/unit_square.h>

#include <fairlight/estimators/sphere_sampling.h>

namespace fairlight {
namespace {

using Light = SphereLight<double>;
using Point = Vec3<double>;

static_assert(LightSampling<SphereByArea<double>>);
static_assert(LightSampling<SphereByVisibleHemisphere<double>>);
static_assert(LightSampling<SphereByCone<Packet>>);

// A sphere of radius 3 with its centre 5 above the origin: sin = 3/5, cos = 4/5.
const Light above({0, 0, 5}, 3);
const Point origin(0, 0, 0);

TEST(SphereByCone, IsUniformInTheConeThatTheSphereFills) {
  const SphereByCone<double> light(above);
  EXPECT_NEAR(light.sample(origin, {0.3, 0.7}).density.value(), 1 / (2 * M_PI * 0.2), 1e-15);
  EXPECT_NEAR(light.pdf(origin, {0, 0, 1}).value(), 1 / (2 * M_PI * 0.2), 1e-15);
  EXPECT_EQ(light.pdf(origin, {0, 0, -1}).value(), 0);
  EXPECT_EQ(light.pdf(origin, {0.61, 0, std::sqrt(1 - 0.61 * 0.61)}).value(), 0);
}

// The distance is 5 - 3 = 2 on the axis, and sqrt(25 - 9) = 4 at the edge of the cone.
TEST(SphereByCone, KnowsTheDistance) {
  const SphereByCone<double> light(above);
  EXPECT_DOUBLE_EQ(light.sample(origin, {0, 0.7}).distance, 2);
  EXPECT_NEAR(light.sample(origin, {1 - 0x1p-53, 0.7}).distance, 4, 1e-7);
}

TEST(SphereByArea, HasTheDensityOfAreaTurnedIntoSolidAngle) {
  EXPECT_NEAR(SphereByArea<double>(above).pdf(origin, {0, 0, 1}).value(), 4 / (36 * M_PI), 1e-15);
  EXPECT_NEAR(SphereByArea<double>(above).sample(origin, {0, 0}).density.value(), 4 / (36 * M_PI), 1e-15);
}

// A direction whose chord near the rim has the length 0.02. The cosine at the hit is half of that
// over the radius.
TEST(SphereByArea, HasADensityUpToTheRim) {
  const double along = std::sqrt(16 + 1e-4), distance = along - 0.01;
  const Vec3<double> grazing(std::sqrt(9 - 1e-4) / 5, 0, along / 5);
  const double density = distance * distance / (36 * M_PI * (0.01 / 3));
  EXPECT_NEAR(SphereByArea<double>(above).pdf(origin, grazing).value() / density, 1, 1e-9);
}

TEST(SphereByArea, HasNoSampleOnTheFarSide) {
  EXPECT_EQ(SphereByArea<double>(above).sample(origin, {0.9, 0.2}).density.value(), 0);
  EXPECT_EQ(SphereByArea<double>(above).pdf(origin, {0, 1, 0}).value(), 0);
}

TEST(SphereByVisibleHemisphere, IsTwiceAsDenseOutsideAndTheSameInside) {
  const SphereByVisibleHemisphere<double> half(above);
  const SphereByArea<double> whole(above);
  const Vec3<double> up(0, 0, 1);
  EXPECT_DOUBLE_EQ(half.pdf(origin, up).value(), 2 * whole.pdf(origin, up).value());
  EXPECT_DOUBLE_EQ(half.pdf({0, 1, 5}, up).value(), whole.pdf({0, 1, 5}, up).value());
}

// From inside, 1 above the centre: 2 upwards, 4 downwards.
TEST(SphereLight, IsSeenInEveryDirectionFromInside) {
  const Point inside(0, 0, 6);
  for (const Vec3<double>& w : {Vec3<double>(0, 0, 1), Vec3<double>(0, 0, -1)}) {
    const double distance = 3 - w.z();
    EXPECT_DOUBLE_EQ(SphereByCone<double>(above).pdf(inside, w).value(), 1 / (4 * M_PI));
    EXPECT_NEAR(SphereByArea<double>(above).pdf(inside, w).value(), distance * distance / (36 * M_PI), 1e-15);
  }
  EXPECT_DOUBLE_EQ(SphereByCone<double>(above).sample(inside, {0, 0}).distance, 4);
  EXPECT_DOUBLE_EQ(SphereByCone<double>(above).sample({0, 0, 5}, {0.3, 0.2}).distance, 3);
}

// From the lowest point every direction that leads inwards hits the sphere again; the vertical one
// does so 6 above.
TEST(SphereLight, ShowsItsInnerFaceToItsSurface) {
  for (const Light& sphere : {above, Light({0, 0, 5}, 3, true)}) {
    const Point lowest(0, 0, 2);
    EXPECT_DOUBLE_EQ(SphereByCone<double>(sphere).sample(lowest, {0, 0}).distance, 6);
    EXPECT_DOUBLE_EQ(SphereByCone<double>(sphere).pdf(lowest, {0, 0, 1}).value(), 1 / (2 * M_PI));
    EXPECT_EQ(SphereByCone<double>(sphere).pdf(lowest, {0, 0, -1}).value(), 0);
    EXPECT_NEAR(SphereByArea<double>(sphere).pdf(lowest, {0, 0, 1}).value(), 1 / M_PI, 1e-15);
    EXPECT_EQ(SphereByArea<double>(sphere).pdf(lowest, {0, 0, -1}).value(), 0);
    EXPECT_EQ(SphereByArea<double>(sphere).sample(lowest, {0, 0}).density.value(), 0);
  }
}

TEST(SphereLight, TakesAPointForOneOfItsSurfaceWhenToldSo) {
  const Point beside(0, 0, 2 - 1e-12);
  EXPECT_NEAR(SphereByCone<double>(above).sample(beside, {0, 0}).distance, 1e-12, 1e-15);
  EXPECT_DOUBLE_EQ(SphereByCone<double>(Light({0, 0, 5}, 3, true)).sample(beside, {0, 0}).distance, 6);
}

TEST(SphereLight, RefusesARadiusThatIsNotPositive) {
  EXPECT_THROW(Light(origin, 0), std::invalid_argument);
  EXPECT_THROW(Light(origin, -1), std::invalid_argument);
  EXPECT_THROW(Light(origin, std::nan("")), std::invalid_argument);
}

TEST(SphereSampling, TakesADirectionThatIsNearlyUnit) {
  for (const Point& from : {origin, Point(0.5, -1, 5)}) {
    const Point towards = (Point(0.25, 0.5, 5) - from).normalized();
    testing::expect_density_off_by_as_much_as_the_direction(SphereByArea<double>(above), from, towards);
    testing::expect_density_off_by_as_much_as_the_direction(SphereByVisibleHemisphere<double>(above), from,
                                                            towards);
    testing::expect_density_off_by_as_much_as_the_direction(SphereByCone<double>(above), from, towards);
  }
}

TEST(SphereSampling, IsTheSameInPackets) {
  for (const Point& from : {Point(0.5, -1, 0.25), Point(0.5, -1, 5), Point(40, 3, -7)}) {
    for (const Vec2<double>& u :
         {Vec2<double>(0.125, 0.25), Vec2<double>(0.5, 0.75), Vec2<double>(0.625, 0.9375)}) {
      const SphereLight<Packet> packets(testing::in_packets({0, 0, 5}), Packet(3.0f));
      testing::expect_same_sample(SphereByArea<double>(above), SphereByArea<Packet>(packets), from, u);
      testing::expect_same_sample(SphereByVisibleHemisphere<double>(above),
                                  SphereByVisibleHemisphere<Packet>(packets), from, u);
      testing::expect_same_sample(SphereByCone<double>(above), SphereByCone<Packet>(packets), from, u);
    }
  }
}

// In floats, too, a sample at the edges of the square is finite; if it exists, it is a unit
// direction.
TEST(SphereSampling, IsInItsDomainAtTheEdgesInPackets) {
  for (float distance : {0.0f, 0.5f, 1.0f, 1.000001f, 3.0f, 1e5f}) {
    const Vec3<Packet> from(Packet(0.0f), Packet(distance), Packet(0.0f));
    const SphereLight<Packet> sphere(Vec3<Packet>(Packet(0.0f), Packet(0.0f), Packet(0.0f)), Packet(1.0f));
    testing::expect_finite_at_edges(SphereByArea<Packet>(sphere), from);
    testing::expect_finite_at_edges(SphereByVisibleHemisphere<Packet>(sphere), from);
    testing::expect_finite_at_edges(SphereByCone<Packet>(sphere), from);
  }
}

TEST(SphereLight, RefusesWhatIsNotFinite) {
  EXPECT_THROW(SphereLight<double>({0, 0, 0}, infinity<double>), std::invalid_argument);
  EXPECT_THROW(SphereLight<double>({0, std::nan(""), 0}, 1), std::invalid_argument);
  EXPECT_THROW(SphereLight<double>({-infinity<double>, 0, 0}, 1), std::invalid_argument);
}

TEST(SphereLight, RefusesLengthsThatFloatsDoNotHold) {
  const Vec3<float> centre(0, 0, 0);
  EXPECT_NO_THROW(SphereLight<float>(centre, 1e-10f));
  EXPECT_NO_THROW(SphereLight<float>(centre, 1e10f));
  EXPECT_THROW(SphereLight<float>(centre, 0.9e-10f), std::invalid_argument);
  EXPECT_THROW(SphereLight<float>(centre, 1.1e10f), std::invalid_argument);
  EXPECT_THROW(SphereLight<float>({0, -1.1e10f, 0}, 1), std::invalid_argument);
  EXPECT_THROW(Light(origin, 1e76), std::invalid_argument);
}

TEST(SphereSampling, RefusesASphereThatIsTooSmallForItsDistance) {
  const SphereLight<float> sphere({0, 0, 0}, 1);
  const Vec3<float> far(0, 0, 1e16f), too_far(0, 0, 1.2e16f);
  EXPECT_GT(SphereByCone<float>(sphere).sample(far, {0.5f, 0.5f}).density.value(), 0);
  for (int i = 1; i < 64; ++i) {  // near the rim, where the density is largest
    const float part = 1 - static_cast<float>(i) * 0x1p-24f;
    EXPECT_LT(SphereByArea<float>(sphere).sample(far, {part / 2, 0.5f}).density.value(), INFINITY) << i;
    EXPECT_LT(SphereByVisibleHemisphere<float>(sphere).sample(far, {part, 0.5f}).density.value(), INFINITY) << i;
  }
  EXPECT_THROW(SphereByCone<float>(sphere).sample(too_far, {0.5f, 0.5f}), std::invalid_argument);
  EXPECT_THROW(SphereByCone<float>(sphere).pdf(too_far, {0, 0, -1}), std::invalid_argument);
  EXPECT_THROW(SphereByArea<float>(sphere).sample(too_far, {0.5f, 0.5f}), std::invalid_argument);
  EXPECT_THROW(SphereByVisibleHemisphere<float>(sphere).pdf(too_far, {0, 0, -1}), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

#include <cmath>

#include <gtest/gtest.h>
#include <support/scripted_source.h>

#include <fairlight/render/path_tracer.h>

namespace fairlight {
namespace {

using testing::ScriptedSource;

const Rgb<double> black(0, 0, 0);
const Rgb<double> half(0.5, 0.5, 0.5);
const Rgb<double> lit(3, 3, 3);

// A point of surface 0 whose normal is +y, seen from above.
template <class Direct>
Rgb<double> reflected(const Direct& direct, const Scene& scene, const Vec3<double>& position,
                      ScriptedSource& source) {
  const TracedScene<double> traced(scene);
  const Vec3<double> up(0, 1, 0);
  const SurfaceBsdf<double> bsdf(traced.materials(), 0, up, up);
  return direct.template estimate<double>(traced, {position, up, 0}, bsdf, source);
}

// The floor's point (0, 0, 0) under a light of radius 1 whose centre is 5 above.
struct Floor {
  Scene scene;
  template <class Direct>
  Rgb<double> reflected(const Direct& direct, ScriptedSource& source) const {
    return fairlight::reflected(direct, scene, {0, 0, 0}, source);
  }
  Floor() {
    scene.add_wall({0, 0, 0}, {0, 1, 0}, 1e5, half, black);
    scene.add_sphere({0, 5, 0}, 1, black, lit);
  }
};

// u = (0, 0) is the light's point that is nearest to the vertex, 4 above it, both cosines 1.
TEST(DirectLight, IsEmissionTimesReflectanceTimesAreaOverDistanceSquared) {
  const Floor floor;
  ScriptedSource source({0, 0});
  const Rgb<double> radiance = floor.reflected(DirectLight<AllLights>(), source);
  EXPECT_NEAR(radiance[0], 3 * (0.5 / M_PI) * (4 * M_PI) / 16, 1e-14);
}

TEST(DirectLight, IsZeroFromTheFarSideOfTheLight) {
  const Floor floor;
  ScriptedSource source({0.9, 0.25});
  EXPECT_TRUE((floor.reflected(DirectLight<AllLights>(), source) == 0).all());
}

TEST(DirectLight, IsZeroInAShadow) {
  Floor floor;
  floor.scene.add_sphere({0, 2, 0}, 0.5, half, black);
  ScriptedSource source({0, 0});
  EXPECT_TRUE((floor.reflected(DirectLight<AllLights>(), source) == 0).all());
}

// A black surface is no luminaire.
TEST(DirectLight, IsZeroWhereNothingEmits) {
  Scene dark;
  dark.add_wall({0, 0, 0}, {0, 1, 0}, 1e5, half, black);
  dark.add_sphere({0, 5, 0}, 1, half, black);
  const auto expect_zero = [&](const auto& direct) {
    ScriptedSource none({});
    EXPECT_TRUE((reflected(direct, dark, {0, 0, 0}, none) == 0).all());
  };
  expect_zero(DirectLight<AllLights>());
  expect_zero(DirectLight<UniformLightSampler>());
  expect_zero(DirectLight(one_by_power(dark)));
  expect_zero(DirectLight<ContributionLightSampler>());
}

// Inside a sphere that emits, cos cos / d^2 = 1 / (4 r^2) for every pair of points, so every draw is rho Le.
TEST(DirectLight, SeesTheLuminaireThatItIsInside) {
  Scene furnace;
  furnace.add_sphere({0, 0, 0}, 2, half, lit);
  for (double u : {0.1, 0.4, 0.9}) {
    ScriptedSource source({u, 0.3});
    const Rgb<double> radiance = reflected(DirectLight<AllLights>(), furnace, {0, -2, 0}, source);
    EXPECT_NEAR(radiance[0], 0.5 * 3, 1e-14) << u;
  }
}

// By the cone a draw is f Le cos / p with p = 1 / (2 pi) and cos = 1 - u, all of whose directions reach the sphere.
TEST(DirectLight, SeesTheLuminaireThatItIsInsideByTheCone) {
  Scene furnace;
  furnace.add_sphere({0, 0, 0}, 2, half, lit);
  ScriptedSource source({0.25, 0.3});
  const DirectLight<AllLights, PointsBy<SphereByCone>> direct;
  const Rgb<double> radiance = reflected(direct, furnace, {0, -2, 0}, source);
  EXPECT_NEAR(radiance[0], 0.5 * 3 * 2 * 0.75, 1e-14);
}

// Two lights of power 1 to 3; the first number chooses, the second refines it. By the cone, whose 1 - cos is
// 1 - sqrt(24)/5, a draw towards the middle of a light is f Le 2 pi (1 - cos) over the light's probability.
TEST(DirectLight, ChoosesALightByItsPower) {
  Floor floor;
  floor.scene.add_sphere({0, -5, 0}, 1, black, 3 * lit);
  const DirectLight<LightSampler<PowerChoice<double>>, PointsBy<SphereByCone>> direct(one_by_power(floor.scene));
  ScriptedSource above({0.24, 0, 0, 0});
  const double cone = 2 * M_PI * (1 - std::sqrt(24) / 5);
  EXPECT_NEAR(floor.reflected(direct, above)[0], 3 * 0.5 / M_PI * cone / 0.25, 1e-14);
  ScriptedSource below({0.26, 0, 0, 0});
  EXPECT_EQ(floor.reflected(direct, below)[0], 0);
}

// Two lights of one size at the distances 5 and 10: powers 1 to 12 over squares 25 to 100 make contributions 1 to 3.
TEST(DirectLight, ChoosesALightByItsContribution) {
  Floor floor;
  floor.scene.add_sphere({0, -10, 0}, 1, black, 12 * lit);
  const DirectLight<ContributionLightSampler, PointsBy<SphereByCone>> direct;
  ScriptedSource above({0.24, 0, 0, 0});
  const double cone = 2 * M_PI * (1 - std::sqrt(24) / 5);
  EXPECT_NEAR(floor.reflected(direct, above)[0], 3 * 0.5 / M_PI * cone / 0.25, 1e-13);
  ScriptedSource below({0.26, 0, 0, 0});
  EXPECT_EQ(floor.reflected(direct, below)[0], 0);
}

TEST(DirectLight, DoesNotLightTheLuminaireFromOutsideByItself) {
  Scene alone;
  alone.add_sphere({0, 0, 0}, 2, half, lit);
  ScriptedSource source({0.5, 0.3});
  EXPECT_TRUE((reflected(DirectLight<AllLights>(), alone, {0, 2, 0}, source) == 0).all());
}

// The camera and single directions have no density; light that a bounce finds else has been found by a shadow ray.
TEST(DirectLight, CountsEmissionOnlyWhereNoShadowRayHas) {
  const TracedScene<double> scene((Scene()));
  const Ray<double> ray{{0, 0, 0}, {0, 0, 1}, -1};
  EXPECT_EQ(DirectLight<AllLights>().emission_weight(scene, ray, 0.0, 0.0), 1);
  EXPECT_EQ(DirectLight<AllLights>().emission_weight(scene, ray, 0.0, 0.3), 0);
  EXPECT_EQ(NoDirectLight::emission_weight(scene, ray, 0.0, 0.3), 1);
}

// A rectangle of area 2 that faces the floor's point from 4 above: f Le A / 16 from its middle, both cosines 1.
TEST(DirectLight, OfARectangle) {
  Scene scene;
  scene.add_wall({0, 0, 0}, {0, 1, 0}, 1e5, half, black);
  scene.add_rectangle({-0.5, 4, -1}, {1, 0, 0}, {0, 0, 2}, black, lit);
  ScriptedSource source({0.5, 0.5});
  EXPECT_NEAR(reflected(DirectLight<AllLights>(), scene, {0, 0, 0}, source)[0], 3 * (0.5 / M_PI) * 2 / 16, 1e-14);
}

// A point of it may be rounded to beside its plane, from where it would fill half of all directions.
TEST(PointsBy, DoNotSeeARectangleFromItself) {
  Scene alone;
  alone.add_rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, half, lit);
  Scene beside_a_sphere = alone;
  beside_a_sphere.add_sphere({0, 0, 5}, 1, half, lit);
  const PointsBy<SphereByArea, RectangleBySolidAngle> points;
  const Vec3<double> beside(0.5, 0.5, 1e-16), towards(0, 0, -1);
  for (const Scene& scene : {alone, beside_a_sphere}) {
    const LightTable<double> lights(scene);
    EXPECT_EQ(points.sample<double>(lights, 0, true, beside, {0.5, 0.5}).density.value(), 0);
    EXPECT_EQ(points.pdf<double>(lights, 0, true, beside, towards).value(), 0);
    EXPECT_NEAR(points.sample<double>(lights, 0, false, beside, {0.5, 0.5}).density.value(), 1 / (2 * M_PI), 1e-14);
    EXPECT_NEAR(points.pdf<double>(lights, 0, false, beside, towards).value(), 1 / (2 * M_PI), 1e-14);
  }
}

}  // namespace
}  // namespace fairlight

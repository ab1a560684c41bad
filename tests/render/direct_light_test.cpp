#include <cmath>

#include <gtest/gtest.h>
#include <support/scripted_source.h>

#include <fairlight/render/path_tracer.h>

namespace fairlight {
namespace {

using testing::ScriptedSource;
using Bsdf = SurfaceBsdf<double, CosineHemisphere>;

const Rgb<double> black(0, 0, 0);
const Rgb<double> half(0.5, 0.5, 0.5);
const Rgb<double> lit(3, 3, 3);

// The floor's point (0, 0, 0), seen from above, under a light of radius 1 whose centre is 5 above.
struct Floor {
  Scene scene;
  Vertex<double> vertex{{0, 0, 0}, {0, 1, 0}, 0};
  Bsdf bsdf{half, {0, 1, 0}, {0, 1, 0}};
  Floor() {
    scene.add_wall({0, 0, 0}, {0, 1, 0}, 1e5, half, black);
    scene.add_sphere({0, 5, 0}, 1, black, lit);
  }
};

// u = (0, 0) is the light's point that is nearest to the vertex, 4 above it, both cosines 1.
TEST(DirectLight, IsEmissionTimesReflectanceTimesAreaOverDistanceSquared) {
  const Floor floor;
  ScriptedSource source({0, 0});
  const Rgb<double> radiance = DirectLight<AllOf>().estimate(floor.scene, floor.vertex, floor.bsdf, source);
  EXPECT_NEAR(radiance[0], 3 * (0.5 / M_PI) * (4 * M_PI) / 16, 1e-14);
}

TEST(DirectLight, IsZeroFromTheFarSideOfTheLight) {
  const Floor floor;
  ScriptedSource source({0.9, 0.25});
  EXPECT_TRUE((DirectLight<AllOf>().estimate(floor.scene, floor.vertex, floor.bsdf, source) == 0).all());
}

TEST(DirectLight, IsZeroInAShadow) {
  Floor floor;
  floor.scene.add_sphere({0, 2, 0}, 0.5, half, black);
  ScriptedSource source({0, 0});
  EXPECT_TRUE((DirectLight<AllOf>().estimate(floor.scene, floor.vertex, floor.bsdf, source) == 0).all());
}

// A black surface is no luminaire. One by weights draws its two numbers before it knows that there is nothing to choose.
TEST(DirectLight, IsZeroWhereNothingEmits) {
  Scene dark;
  dark.add_wall({0, 0, 0}, {0, 1, 0}, 1e5, half, black);
  dark.add_sphere({0, 5, 0}, 1, half, black);
  const Floor floor;
  const auto expect_zero = [&](const auto& direct, ScriptedSource source) {
    EXPECT_TRUE((direct.estimate(dark, floor.vertex, floor.bsdf, source) == 0).all());
    EXPECT_TRUE(source.exhausted());
  };
  const auto weight = [](int) -> double { throw std::logic_error("there is no light to be weighed"); };
  const OneBy by_contribution(ContributionChoice<double, decltype(weight)>(0, weight));
  expect_zero(DirectLight<AllOf>(), ScriptedSource({}));
  expect_zero(DirectLight<OneOf>(), ScriptedSource({}));
  expect_zero(DirectLight(one_by_power(dark)), ScriptedSource({0.5, 0.25}));
  expect_zero(DirectLight(by_contribution), ScriptedSource({0.5, 0.25}));
}

// Inside a sphere that emits, cos cos / d^2 = 1 / (4 r^2) for every pair of points, so every draw is rho Le.
TEST(DirectLight, SeesTheLuminaireThatItIsInside) {
  Scene furnace;
  furnace.add_sphere({0, 0, 0}, 2, half, lit);
  const Vertex<double> vertex{{0, -2, 0}, {0, 1, 0}, 0};
  for (double u : {0.1, 0.4, 0.9}) {
    ScriptedSource source({u, 0.3});
    const Rgb<double> radiance =
        DirectLight<AllOf>().estimate(furnace, vertex, Bsdf(half, {0, 1, 0}, {0, 1, 0}), source);
    EXPECT_NEAR(radiance[0], 0.5 * 3, 1e-14) << u;
  }
}

// By the cone a draw is f Le cos / p with p = 1 / (2 pi) and cos = 1 - u, all of whose directions reach the sphere.
TEST(DirectLight, SeesTheLuminaireThatItIsInsideByTheCone) {
  Scene furnace;
  furnace.add_sphere({0, 0, 0}, 2, half, lit);
  const Vertex<double> vertex{{0, -2, 0}, {0, 1, 0}, 0};
  ScriptedSource source({0.25, 0.3});
  const DirectLight<AllOf, SphereByCone> direct;
  const Rgb<double> radiance = direct.estimate(furnace, vertex, Bsdf(half, {0, 1, 0}, {0, 1, 0}), source);
  EXPECT_NEAR(radiance[0], 0.5 * 3 * 2 * 0.75, 1e-14);
}

// Two lights of power 1 to 3; the first number chooses, the second refines it. By the cone, whose 1 - cos is
// 1 - sqrt(24)/5, a draw towards the middle of a light is f Le 2 pi (1 - cos) over the light's probability.
TEST(DirectLight, ChoosesALightByItsPower) {
  Floor floor;
  floor.scene.add_sphere({0, -5, 0}, 1, black, 3 * lit);
  const DirectLight<OneBy<PowerChoice<double>>, SphereByCone> direct(one_by_power(floor.scene));
  ScriptedSource above({0.24, 0, 0, 0});
  const double cone = 2 * M_PI * (1 - std::sqrt(24) / 5);
  EXPECT_NEAR(direct.estimate(floor.scene, floor.vertex, floor.bsdf, above)[0], 3 * 0.5 / M_PI * cone / 0.25,
              1e-14);
  ScriptedSource below({0.26, 0, 0, 0});
  EXPECT_EQ(direct.estimate(floor.scene, floor.vertex, floor.bsdf, below)[0], 0);
}

// By what each may bring to the vertex: that below the floor nothing, so that every draw is of the one above.
TEST(DirectLight, ChoosesALightByItsContribution) {
  Floor floor;
  floor.scene.add_sphere({0, -5, 0}, 1, black, 3 * lit);
  const auto above = [&](int i) {
    return floor.scene.luminaires()[static_cast<std::size_t>(i)].centre.y() > 0 ? 1.0 : 0.0;
  };
  const OneBy by_contribution(ContributionChoice<double, decltype(above)>(2, above));
  const DirectLight<std::remove_cv_t<decltype(by_contribution)>, SphereByCone> direct(by_contribution);
  ScriptedSource source({0.99, 0, 0, 0});
  const double cone = 2 * M_PI * (1 - std::sqrt(24) / 5);
  EXPECT_NEAR(direct.estimate(floor.scene, floor.vertex, floor.bsdf, source)[0], 3 * 0.5 / M_PI * cone, 1e-14);
}

TEST(DirectLight, DoesNotLightTheLuminaireFromOutsideByItself) {
  Scene alone;
  alone.add_sphere({0, 0, 0}, 2, half, lit);
  const Vertex<double> vertex{{0, 2, 0}, {0, 1, 0}, 0};
  ScriptedSource source({0.5, 0.3});
  EXPECT_TRUE((DirectLight<AllOf>().estimate(alone, vertex, Bsdf(half, {0, 1, 0}, {0, 1, 0}), source) == 0).all());
}

TEST(CountsEmission, OnlyWhereNoShadowRayHasCountedIt) {
  EXPECT_TRUE(DirectLight<AllOf>::counts_emission(0));
  EXPECT_FALSE(DirectLight<AllOf>::counts_emission(1));
  EXPECT_TRUE(NoDirectLight::counts_emission(5));
}

}  // namespace
}  // namespace fairlight

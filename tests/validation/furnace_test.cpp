#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>
#include <support/scripted_source.h>

#include <fairlight/validation/claims/furnace.h>

namespace fairlight {
namespace {

constexpr int blue = 2;  // reflects most, and so as much as roulette lets go on

// Terms that fall to 0.3 / 0.7 of the one before add up, and none is beyond; blue ones go on alike, for a geometric time.
TEST(Furnace, HasARangeOfAllItsTermsOrATail) {
  const Furnace furnace;
  const Reference red = furnace.reference_within(0, 1, {0.3, 0.6, 0.7});
  EXPECT_NEAR(red.mean, 1 / 0.7, 1e-15);
  EXPECT_NEAR(red.upper, 1 + 0.6 / (1 - 0.3 / 0.7), 1e-8);
  EXPECT_EQ(red.tail_slack, 0);
  const GeometricSum terms{0.35, 0.7, 0.7};
  const Reference same = furnace.reference_within(blue, 1, terms);
  EXPECT_NEAR(same.mean, 0.5 / 0.3, 1e-15);
  EXPECT_EQ(same.tail_slack, 1e-9 * same.mean);
  EXPECT_EQ(same.upper, 1 + terms.bound(same.tail_slack));
}

TEST(Furnace, RefusesTermsThatGrow) {
  EXPECT_THROW(Furnace().reference_within(blue, 1, {0.35, 0.7, 0.6}), std::invalid_argument);
}

// The most that shadow rays bring at any of some vertices of the two spheres, relative to rho Le, of points all over the luminaires. The
// spheres are nearest to each other along x.
template <class Direct>
double most_of(const Direct& direct) {
  const Scene scene = furnace_with_another().scene;
  const TracedScene<double> traced(scene);
  constexpr int n = 64;
  double most = 0;
  for (const Vec3<double>& w : {Vec3<double>(1, 0, 0), {-1, 0, 0}, {0, 1, 0}, {0.6, 0, 0.8}, {0.98, 0.199, 0}}) {
    for (int surface : {0, 1}) {
      const Vec3<double> centre = surface == 0 ? Vec3<double>(3, -2, 5) : Vec3<double>(5, -2, 5);
      const Vec3<double> direction = w.normalized(), normal = surface == 0 ? Vec3<double>(-direction) : direction;
      const Vertex<double> vertex{centre + (surface == 0 ? 7 : 1) * direction, normal,
                                  static_cast<double>(surface)};
      const SurfaceBsdf<double> bsdf(traced.materials(), surface, normal, normal);
      for (int i = 0; i < n * n; ++i) {
        const double u = (i % n + 0.5) / n, v = (static_cast<double>(i / n) + 0.5) / n;
        for (double which : {0.0, 0.99}) {
          testing::ScriptedSource source(direct.chooses ? std::vector{which, 0.5, u, v} : std::vector{u, v, u, v});
          const Rgb<double> found = direct.light.template estimate<double>(traced, vertex, bsdf, source);
          most = std::max(most, found[blue] / (0.7 * 0.5));
        }
      }
    }
  }
  return most;
}
template <class Light>
struct ShadowRays {
  Light light;
  bool chooses;
};

// As the ranges of furnace.two_spheres.* declare: not more, nor much less.
TEST(TwoSpheres, BringAtAVertexWhatTheirRangesSay) {
  const auto expect_near = [](double most, double declared) {
    EXPECT_LE(most, declared);
    EXPECT_GE(most, 0.8 * declared);
  };
  using ByCone = PointsBy<SphereByCone>;
  const auto by_power = one_by_power(furnace_with_another().scene);
  expect_near(most_of(ShadowRays{DirectLight<AllLights>(), false}), 12.25);
  expect_near(most_of(ShadowRays{DirectLight<UniformLightSampler>(), true}), 24.5);
  expect_near(most_of(ShadowRays{DirectLight<AllLights, ByCone>(), false}), 4.1);
  expect_near(most_of(ShadowRays{DirectLight<decltype(by_power), ByCone>(by_power), true}), 4.1);
}

}  // namespace
}  // namespace fairlight

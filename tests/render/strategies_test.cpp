#include <gtest/gtest.h>
#include <support/scripted_source.h>

#include <fairlight/render/built_in_scenes.h>
#include <fairlight/render/strategies.h>

namespace fairlight {
namespace {

using testing::ScriptedSource;

// A floor that a light of radius 1 stands over, 5 above it.
Scene lit_floor() {
  Scene scene;
  scene.add_wall({0, 0, 0}, {0, 1, 0}, 1e5, Rgb<double>(0.5, 0.5, 0.5), Rgb<double>(0, 0, 0));
  scene.add_sphere({0, 5, 0}, 1, Rgb<double>(0, 0, 0), Rgb<double>(3, 3, 3));
  return scene;
}

// Straight up from the floor, by a shadow ray and by a bounce. By cone p_l = 1 / (2 pi (1 - sqrt(24)/5)), by cosine p_b = 1 / pi;
// the two parts, each by its own density and weighed by the balance heuristic, are f Le / (p_l + p_b).
TEST(Sharing, DividesWhatBothFindByTheSumOfDensities) {
  const Scene floor = lit_floor();
  const TracedScene<double> scene(floor);
  const DirectLight<AllLights, PointsBy<SphereByCone>, MisWeighted<>> direct;
  const Vec3<double> up(0, 1, 0);
  const SurfaceBsdf<double> bsdf(scene.materials(), 0, up, up);
  const double by_light = 1 / (2 * M_PI * (1 - std::sqrt(24) / 5));
  const double by_bounce = 1 / M_PI;
  ScriptedSource middle({0, 0});
  const Vertex<double> vertex{{0, 0, 0}, up, 0};
  EXPECT_NEAR(direct.estimate<double>(scene, vertex, bsdf, middle)[0], 0.5 / M_PI * 3 / (by_light + by_bounce),
              1e-12);
  const Ray<double> ray{{0, 0, 0}, up, 0};
  EXPECT_NEAR(direct.emission_weight(scene, ray, 1.0, by_bounce), by_bounce / (by_light + by_bounce), 1e-12);
  EXPECT_EQ(direct.emission_weight(scene, ray, 1.0, 0.0), 1) << "no shadow ray finds a single direction";
  EXPECT_EQ(direct.emission_weight(scene, ray, 0.0, by_bounce), 1) << "the floor is no luminaire";
}

// One of two lights is found by a shadow ray half as often.
TEST(Sharing, KnowsHowALightIsChosen) {
  Scene floor = lit_floor();
  floor.add_sphere({0, -5, 0}, 1, Rgb<double>(0, 0, 0), Rgb<double>(3, 3, 3));
  const TracedScene<double> scene(floor);
  const Ray<double> ray{{0, 0, 0}, {0, 1, 0}, 0};
  const double by_light = 0.5 / (2 * M_PI * (1 - std::sqrt(24) / 5));
  const auto weight = [&](const auto& direct) { return direct.emission_weight(scene, ray, 1.0, 1 / M_PI); };
  const double expected = 1 / M_PI / (by_light + 1 / M_PI);
  EXPECT_NEAR(weight(DirectLight<UniformLightSampler, PointsBy<SphereByCone>, MisWeighted<>>()), expected, 1e-12);
  EXPECT_NEAR(weight(DirectLight<ContributionLightSampler, PointsBy<SphereByCone>, MisWeighted<>>()), expected,
              1e-12);
  using ByPower = DirectLight<LightSampler<PowerChoice<double>>, PointsBy<SphereByCone>, MisWeighted<>>;
  EXPECT_NEAR(weight(ByPower(one_by_power(floor))), expected, 1e-12);
}

// Of paths that carry 1/2 to a surface that reflects half, all make the bounces before it, and none the bounce itself at 0.9.
TEST(ChosenRoulette, BeginsAtTheBounceThatIsAskedForOrItsOwn) {
  const auto first_refused = [](RouletteKind kind, int asked) {
    RenderSettings settings;
    settings.roulette = kind;
    settings.roulette_depth = asked;
    const ChosenRoulette roulette = chosen_roulette(Strategies(settings, lit_floor()));
    const Rgb<double> half(0.5, 0.5, 0.5);
    for (int bounce = 1; bounce < 20; ++bounce) {
      ScriptedSource source({0.9});
      if (!roulette.play<double>(half, half, bounce - 1, source).alive) return bounce;
    }
    return 0;
  };
  EXPECT_EQ(first_refused(RouletteKind::albedo, -1), 1);
  EXPECT_EQ(first_refused(RouletteKind::throughput, -1), 5);
  EXPECT_EQ(first_refused(RouletteKind::albedo, 4), 4);
  EXPECT_EQ(first_refused(RouletteKind::throughput, 3), 3);
  EXPECT_THROW(first_refused(RouletteKind::throughput, 0), std::invalid_argument);
}

TEST(Strategies, RefuseADepthOfRouletteWithoutIt) {
  RenderSettings settings;
  settings.roulette = RouletteKind::off;
  settings.max_depth = 3;
  EXPECT_NO_THROW(Strategies(settings, lit_floor()));
  settings.roulette_depth = 2;
  EXPECT_THROW(Strategies(settings, lit_floor()), std::invalid_argument);
}

TEST(Strategies, RefuseARouletteThatBeginsAfterTheLastBounce) {
  RenderSettings settings;
  settings.max_depth = 3;
  settings.roulette_depth = 3;
  EXPECT_NO_THROW(Strategies(settings, lit_floor()));
  settings.roulette_depth = 4;
  EXPECT_THROW(Strategies(settings, lit_floor()), std::invalid_argument);
}

// A mirror shows the light, which no shadow ray finds in it: all of its emission counts.
TEST(SurfaceBsdf, OfAMirrorIsSeenThroughByTheBounceAlone) {
  Scene scene;
  scene.add_wall({0, 0, 0}, {0, 1, 0}, 1e5, {Material::Kind::mirror, Rgb<double>(0.5, 0.5, 0.5), 1},
                 Rgb<double>(0, 0, 0));
  scene.add_sphere({0, 5, 0}, 1, Rgb<double>(0, 0, 0), Rgb<double>(3, 3, 3));
  for (const auto& direct : StrategyTable<DirectLighting>::rows) {
    RenderSettings settings;
    settings.light_sampling = LightPoints::cone;
    settings.roulette = RouletteKind::off;
    settings.direct = direct.value;
    settings.max_depth = 1;
    const auto tracer = chosen_tracer<double>(Strategies(settings, scene), scene);
    ScriptedSource source({0, 0, 0.5, 0.5});
    const Ray<double> down{{0.1, 2, 0}, {0, -1, 0}, -1};
    EXPECT_NEAR(tracer.radiance(TracedScene<double>(scene), down, source)[0], 0.5 * 3, 1e-12) << direct.name;
  }
}

}  // namespace
}  // namespace fairlight

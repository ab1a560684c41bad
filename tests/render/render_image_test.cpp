#include <stdexcept>

#include <gtest/gtest.h>

#include <fairlight/render/render_image.h>

namespace fairlight {
namespace {

RenderSettings small() {
  RenderSettings settings;
  settings.width = 37;  // no multiple of a tile
  settings.height = 19;
  return settings;
}

Film render(const RenderSettings& settings, SampleRange range, int threads) {
  Film film(settings.width, settings.height);
  render_image(built_in_scene(settings.scene), settings, 11, range, threads, film, {});
  return film;
}

TEST(RenderImage, IsTheSameForAnyNumberOfThreads) {
  const Film one = render(small(), {0, 8}, 1);
  EXPECT_EQ(one, render(small(), {0, 8}, 2));
  EXPECT_EQ(one, render(small(), {0, 8}, 7));
}

TEST(RenderImage, IsTheSumOfItsParts) {
  Film parts = render(small(), {5, 8}, 2);
  parts.merge(render(small(), {0, 5}, 2));
  EXPECT_EQ(parts, render(small(), {0, 8}, 2));
}

TEST(RenderImage, CountsPathsAndRays) {
  RenderSettings settings = small();
  settings.max_depth = 0;
  Film film(settings.width, settings.height);
  const RenderCost cost = render_image(built_in_scene(settings.scene), settings, 11, {0, 4}, 2, film, {});
  EXPECT_EQ(cost.paths, 37u * 19 * 4);
  EXPECT_EQ(cost.rays, cost.paths);
}

TEST(RenderImage, RunsEveryStrategy) {
  for (const char* bounce : {"cosine", "uniform"}) {
    for (const char* direct : {"light", "none"}) {
      for (const char* which : {"all", "one"}) {
        for (const char* roulette : {"albedo", "off"}) {
          RenderSettings settings = small();
          settings.bounce = bounce;
          settings.direct = direct;
          settings.which_light = which;
          settings.roulette = roulette;
          settings.max_depth = 3;
          EXPECT_EQ(render(settings, {0, 1}, 2).at(0, 0)[0].count(), 1u);
        }
      }
    }
  }
}

TEST(RenderImage, RefusesPathsThatMightNotEnd) {
  RenderSettings settings = small();
  settings.roulette = "off";
  EXPECT_THROW(render(settings, {0, 1}, 1), std::invalid_argument);
}

TEST(RenderImage, RefusesUniformBouncesWithoutADepthSinceTheirVarianceIsInfinite) {
  RenderSettings settings = small();
  settings.bounce = "uniform";
  EXPECT_THROW(render(settings, {0, 1}, 1), std::invalid_argument);
}

TEST(RenderImage, RefusesStrategiesThatDoNotExist) {
  for (std::string RenderSettings::*strategy :
       {&RenderSettings::bounce, &RenderSettings::direct, &RenderSettings::light_sampling,
        &RenderSettings::which_light, &RenderSettings::roulette, &RenderSettings::filter}) {
    RenderSettings settings = small();
    settings.*strategy = "sideways";
    EXPECT_THROW(render(settings, {0, 1}, 1), std::invalid_argument);
  }
}

}  // namespace
}  // namespace fairlight

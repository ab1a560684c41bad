#include <stdexcept>

#include <boost/math/distributions/poisson.hpp>
#include <gtest/gtest.h>

#include <fairlight/render/instruction_sets.h>
#include <fairlight/render/render_image.h>
#include <fairlight/stats/seed.h>

namespace fairlight {
namespace {

RenderSettings small() {
  RenderSettings settings;
  settings.width = 37;  // no multiple of a tile
  settings.height = 19;
  return settings;
}

RenderSettings small(RandomNumbers random, std::uint32_t points) {
  RenderSettings settings = small();
  settings.random = random;
  settings.points = points;
  return settings;
}

Film render(const RenderSettings& settings, SampleRange range, int threads, const std::string& instructions = "") {
  Film film(settings.width, settings.height);
  render_image(view_of(settings), settings, 11, range, threads, film, {}, instructions);
  return film;
}

// In every arithmetic, by every instruction set that this machine has.
TEST(RenderImage, IsTheSameForAnyNumberOfThreads) {
  const auto expect_same = [](const RenderSettings& settings, const std::string& instructions) {
    const Film one = render(settings, {0, 8}, 1, instructions);
    EXPECT_EQ(one, render(settings, {0, 8}, 2, instructions)) << instructions;
    EXPECT_EQ(one, render(settings, {0, 8}, 7, instructions)) << instructions;
  };
  RenderSettings settings = small();
  for (const InstructionSet& set : instruction_sets()) {
    if (set.runs_here) expect_same(settings, set.name);
  }
  settings.real = Arithmetic::doubles;
  expect_same(settings, "");
  for (const RandomNumbers random : {RandomNumbers::sobol, RandomNumbers::stratified}) {
    settings = small(random, 4);
    expect_same(settings, "");
    settings.real = Arithmetic::doubles;
    expect_same(settings, "");
  }
}

// How many pixels part from those of the widest instructions by more than a thousandth, which
// roundings do not come to where paths are the same; and how many rays these took.
std::pair<int, std::uint64_t> parted(const RenderSettings& settings, const std::string& instructions,
                                     std::uint64_t seed) {
  const View view = view_of(settings);
  Film one(settings.width, settings.height), other = one;
  const std::uint64_t rays = render_image(view, settings, seed, {0, 4}, 1, one, {}).rays;
  render_image(view, settings, seed, {0, 4}, 1, other, {}, instructions);
  int parted = 0;
  for (int i = 0; i < settings.width * settings.height; ++i) {
    const Rgb<double> a = one.mean(i % settings.width, i / settings.width);
    const Rgb<double> b = other.mean(i % settings.width, i / settings.width);
    parted += ((a - b).abs() > 1e-3 * (a + b)).any() ? 1 : 0;
  }
  return {parted, rays};
}

// Instruction sets round floats differently, which parts a path where a number that decides falls
// that close to what it is compared with: within 5e-6 on either side, as 84 roundings come to,
// which all claims in packets allow for. With ten such comparisons, of the edges that a ray passes
// and of roulette, one ray in 10^4 parts. The limit is the quantile of so many at 1e-6 for all
// comparisons; of numbers that are not the same nearly all pixels part.
TEST(RenderImage, FollowsTheSamePathsByEveryInstructionSet) {
  const std::uint64_t seed = fresh_seed();
  const double level = 1e-6 / static_cast<double>(scene_names().size() * 3 * instruction_sets().size());
  for (const std::string& scene : scene_names()) {
    for (const auto& numbers : StrategyTable<RandomNumbers>::rows) {
      RenderSettings settings = small(numbers.value, numbers.value == RandomNumbers::independent ? 1 : 4);
      settings.scene = scene;
      for (const InstructionSet& set : instruction_sets()) {
        if (!set.runs_here) continue;
        const auto [pixels, rays] = parted(settings, set.name, seed);
        const boost::math::poisson expected(1e-4 * static_cast<double>(rays));
        EXPECT_LE(pixels, boost::math::quantile(boost::math::complement(expected, level)))
            << scene << ", " << numbers.name << " by " << set.name << ", seed " << seed_text(seed);
      }
    }
  }
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

// A set is a draw: its samples depend on each other.
TEST(RenderImage, AddsTheMeansOfSets) {
  for (const RandomNumbers random : {RandomNumbers::sobol, RandomNumbers::stratified}) {
    EXPECT_EQ(render(small(random, 8), {0, 24}, 2).at(5, 5)[0].count(), 3u);
    const Film set = render(small(random, 8), {0, 8}, 2);
    EXPECT_EQ(set.at(5, 5)[0].count(), 1u);
    EXPECT_EQ(set.at(5, 5)[0].standard_error(), infinity<double>);
  }
}

// Also sets that are larger than what is held at once otherwise, or do not divide it.
TEST(RenderImage, IsTheSumOfWholeSetsForAnyNumberOfThreads) {
  for (const std::uint32_t points : {1u, 4u, 64u, 256u}) {
    RenderSettings settings = small(RandomNumbers::sobol, points);
    settings.width = 17;
    settings.height = 3;
    Film parts = render(settings, {2 * points, 3 * points}, 7);
    parts.merge(render(settings, {0, 2 * points}, 2));
    EXPECT_EQ(parts, render(settings, {0, 3 * points}, 1)) << points;
  }
}

TEST(RenderImage, RefusesPartsOfSets) {
  EXPECT_THROW(render(small(RandomNumbers::sobol, 16), {0, 24}, 1), std::invalid_argument);
  EXPECT_THROW(render(small(RandomNumbers::stratified, 16), {8, 24}, 1), std::invalid_argument);
  EXPECT_THROW(render(small(RandomNumbers::sobol, 0), {0, 16}, 1), std::invalid_argument);
  EXPECT_THROW(render(small(RandomNumbers::stratified, 12), {0, 12}, 1), std::invalid_argument);
  EXPECT_THROW(render(small(RandomNumbers::independent, 16), {0, 16}, 1), std::invalid_argument);
}

// Roulette spares lanes for themselves: what a path draws afterwards does not hang on where the other lanes are.
TEST(RenderImage, IsTheSumOfItsPartsWhereRouletteBeginsLater) {
  RenderSettings settings = small();
  settings.direct = DirectLighting::none;
  settings.roulette_depth = 2;
  Film parts = render(settings, {1, 4}, 2);
  parts.merge(render(settings, {0, 1}, 2));
  EXPECT_EQ(parts, render(settings, {0, 4}, 2));
}

// More samples than are held at once, in parts that divide neither packets nor what is held.
TEST(RenderImage, IsTheSumOfItsPartsAcrossWhatIsHeldAtOnce) {
  Film parts = render(small(), {65, 70}, 2);
  parts.merge(render(small(), {0, 65}, 2));
  EXPECT_EQ(parts, render(small(), {0, 70}, 2));
}

TEST(RenderImage, RunsEveryScene) {
  for (const std::string& scene : scene_names()) {
    for (const auto& real : StrategyTable<Arithmetic>::rows) {
      RenderSettings settings = small();
      settings.scene = scene;
      settings.real = real.value;
      const Film film = render(settings, {0, 2}, 2);
      Rgb<double> sum(0, 0, 0);
      for (int x = 0; x < film.width(); ++x) sum += film.mean(x, film.height() / 2);
      EXPECT_GT(sum.minCoeff(), 0) << scene;
    }
  }
}

TEST(RenderImage, RunsOnOnePixel) {
  RenderSettings settings = small();
  settings.width = settings.height = 1;
  EXPECT_EQ(render(settings, {0, 3}, 7).at(0, 0)[0].count(), 3u) << "more threads than pixels";
}

TEST(RenderImage, RefusesByNameWhatASceneDoesNotAdmit) {
  const auto expect_refusal = [](const std::string& scene, LightPoints sampling) {
    RenderSettings settings = small();
    settings.scene = scene;
    settings.light_sampling = sampling;
    try {
      render(settings, {0, 1}, 1);
      FAIL() << scene;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(name_of(sampling)), std::string::npos) << error.what();
    }
  };
  expect_refusal("cornell-original", LightPoints::cone);
  expect_refusal("cornell-original", LightPoints::visible);
  expect_refusal("cornell-simple", LightPoints::solid_angle);
}

TEST(RenderImage, RefusesShadowRaysWhereThereAreNoLuminaires) {
  const View dark{"dark", Scene(), view_of(small()).camera};
  Film film(4, 4);
  RenderSettings settings;
  EXPECT_THROW(render_image(dark, settings, 1, {0, 1}, 1, film, {}), std::invalid_argument);
  settings.direct = DirectLighting::none;
  EXPECT_NO_THROW(render_image(dark, settings, 1, {0, 1}, 1, film, {}));
}

TEST(ViewOf, TakesTheLensThatIsAskedFor) {
  RenderSettings settings;
  EXPECT_FALSE(view_of(settings).camera.has_lens());
  settings.aperture = 2;
  settings.focus = 150;
  settings.fov = 90;
  const CameraSettings camera = view_of(settings).camera.settings();
  EXPECT_EQ(camera.aperture_radius, 2);
  EXPECT_EQ(camera.focus_distance, 150);
  EXPECT_DOUBLE_EQ(camera.image_height, 2);
  settings.fov = 180;
  EXPECT_THROW(view_of(settings), std::invalid_argument);
}

TEST(RenderImage, RefusesPathsThatMightNotEnd) {
  RenderSettings settings = small();
  settings.roulette = RouletteKind::off;
  EXPECT_THROW(render(settings, {0, 1}, 1), std::invalid_argument);
}

TEST(RenderImage, RefusesUniformBouncesWithoutADepthSinceTheirVarianceIsInfinite) {
  RenderSettings settings = small();
  settings.bounce = BounceSampling::uniform;
  EXPECT_THROW(render(settings, {0, 1}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

#include <stdexcept>

#include <gtest/gtest.h>
#include <support/scripted_source.h>

#include <fairlight/render/path_tracer.h>

namespace fairlight {
namespace {

using testing::ScriptedSource;
using Bouncing = PathTracer<BouncesBy<CosineHemisphere>, NoDirectLight, NoRoulette>;
using Lighting = PathTracer<BouncesBy<CosineHemisphere>, DirectLight<AllLights>, NoRoulette>;
using Gambling = PathTracer<BouncesBy<CosineHemisphere>, NoDirectLight, RouletteByReflectance<>>;

const Rgb<double> emitted(1, 2, 4);
const Rgb<double> albedo(0.5, 0.25, 0.125);

TracedScene<double> furnace() {
  Scene scene;
  scene.add_sphere({0, 0, 0}, 1, albedo, emitted);
  return TracedScene<double>(scene);
}

const Ray<double> ray{{0.1, 0.2, 0.3}, {0, 0, 1}, -1};

void expect_partial_sum(const Rgb<double>& radiance, int terms) {
  Rgb<double> expected = Rgb<double>::Zero();
  Rgb<double> throughput = Rgb<double>::Ones();
  for (int i = 0; i < terms; ++i, throughput *= albedo) expected += throughput * emitted;
  EXPECT_TRUE(radiance.isApprox(expected, 1e-14)) << radiance.transpose() << " for " << expected.transpose();
}

TEST(PathTracer, AddsEmissionAtEveryVertexUpToTheDepth) {
  for (int depth : {0, 1, 2}) {
    ScriptedSource source(std::vector<double>(static_cast<std::size_t>(2 * depth), 0.4));
    expect_partial_sum(Bouncing(depth).radiance(furnace(), ray, source), depth + 1);
    EXPECT_TRUE(source.exhausted());
  }
}

TEST(PathTracer, FindsTheSameTermsByShadowRays) {
  // Per depth a shadow ray and, but for the last, a bounce: two numbers each.
  for (int depth : {0, 1, 2}) {
    ScriptedSource source(std::vector<double>(static_cast<std::size_t>(depth == 0 ? 0 : 4 * depth - 2), 0.4));
    expect_partial_sum(Lighting(depth).radiance(furnace(), ray, source), depth + 1);
    EXPECT_TRUE(source.exhausted());
  }
}

TEST(PathTracer, PaysSurvivorsOfRoulette) {
  // Survives 0.4 < 0.5, bounces, dies at 0.6: the second vertex counts albedo / 0.5.
  ScriptedSource source({0.4, 0.3, 0.7, 0.6});
  const Rgb<double> radiance = Gambling().radiance(furnace(), ray, source);
  EXPECT_TRUE(radiance.isApprox(emitted + emitted * albedo / 0.5, 1e-14));
  EXPECT_TRUE(source.exhausted());
}

TEST(PathTracer, TellsRouletteWhatAPathCarriesAndHowDeepItIs) {
  using Later = PathTracer<BouncesBy<CosineHemisphere>, NoDirectLight, RouletteFromBounce<RouletteByThroughput<>>>;
  const Later later(-1, {}, {}, RouletteFromBounce<RouletteByThroughput<>>(2));
  // A bounce that roulette spares, though its number is 0.99, to a throughput of 1/2, 1/4, 1/8; a second would leave 1/4 of it: survives 0.2, bounces, carries 1,
  // 1/4, 1/16, and dies at 0.51.
  ScriptedSource source({0.99, 0.3, 0.7, 0.2, 0.3, 0.7, 0.51});
  const Rgb<double> radiance = later.radiance(furnace(), ray, source);
  EXPECT_TRUE(radiance.isApprox(emitted * (1 + albedo + albedo * albedo / 0.25), 1e-14));
  EXPECT_TRUE(source.exhausted());
}

TEST(PathTracer, SeesNothingWhereThereIsNothing) {
  ScriptedSource none({});
  EXPECT_TRUE((Bouncing(3).radiance(TracedScene<double>(Scene()), ray, none) == 0).all());
}

TEST(PathTracer, EndsAPathThatCarriesNothing) {
  Scene black;
  black.add_sphere({0, 0, 0}, 1, Rgb<double>::Zero(), emitted);
  ScriptedSource one_bounce({0.4, 0.4});
  EXPECT_TRUE((Bouncing().radiance(TracedScene<double>(black), ray, one_bounce) == emitted).all());
}

TEST(PathTracer, RefusesANegativeDepth) { EXPECT_THROW(Bouncing(-2), std::invalid_argument); }

}  // namespace
}  // namespace fairlight

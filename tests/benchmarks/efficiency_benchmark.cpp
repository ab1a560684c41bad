// What a CPU second of a render buys: 1/(MSE x CPU seconds) of `cornell-simple` at 256 x 256 and 64 samples a pixel, one thread, by
// strategy. The MSE is half the mean squared difference of two seeds, over channels and pixels; left out are the three rows at the
// top and what is within three pixels of the visible light, whose edge is all that a filter's noise is about.
#include <algorithm>
#include <ctime>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include <fairlight/render/geometry.h>
#include <fairlight/render/render_image.h>
#include <fairlight/stats/text.h>

namespace {

using namespace fairlight;

constexpr int size = 256, samples = 64, margin = 3;

/// Whether pixels count, row by row.
std::vector<bool> counted(const View& view) {
  const Geometry<double> geometry(view.scene);
  std::vector<bool> counts(size * size);
  for (int i = margin * size; i < size * size; ++i) counts[static_cast<std::size_t>(i)] = true;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const Hit<double> hit = geometry.intersect(view.camera.ray<double>(x + 0.5, y + 0.5, size, size));
      if (hit.surface < 0 || !(view.scene.surfaces()[static_cast<std::size_t>(hit.surface)].radiance > 0).any())
        continue;
      for (int v = std::max(y - margin, 0); v <= std::min(y + margin, size - 1); ++v) {
        for (int u = std::max(x - margin, 0); u <= std::min(x + margin, size - 1); ++u) {
          counts[static_cast<std::size_t>(v * size + u)] = false;
        }
      }
    }
  }
  return counts;
}

double mean_squared_error(const Film& a, const Film& b, const std::vector<bool>& counts) {
  double sum = 0, n = 0;
  for (int i = 0; i < size * size; ++i) {
    if (!counts[static_cast<std::size_t>(i)]) continue;
    sum += (a.mean(i % size, i / size) - b.mean(i % size, i / size)).square().mean() / 2;
    ++n;
  }
  return sum / n;
}

void efficiency(benchmark::State& state, const RenderSettings& settings) {
  const View view = built_in_scene(settings.scene);
  const std::vector<bool> counts = counted(view);
  static std::uint64_t seed = 0;  // no two repetitions render the same
  double error = 0, seconds = 0, n = 0;
  for (auto _ : state) {
    Film a(size, size), b(size, size);
    const std::clock_t start = std::clock();
    for (Film* film : {&a, &b}) render_image(view, settings, ++seed, {0, samples}, 1, *film, {});
    seconds += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / 2;
    error += mean_squared_error(a, b, counts);
    ++n;
  }
  state.counters["seconds"] = seconds / n;
  state.counters["variance"] = samples * error / n;
  state.counters["efficiency"] = n * n / (error * seconds);
}

struct Choice {
  LightPoints light_sampling;
  DirectLighting direct = DirectLighting::light;
  RandomNumbers random = RandomNumbers::independent;
};

void add(const Choice& choice) {
  RenderSettings settings;
  settings.width = settings.height = size;
  settings.roulette = RouletteKind::throughput;
  settings.light_sampling = choice.light_sampling;
  settings.direct = choice.direct;
  settings.random = choice.random;
  settings.points = settings.random == RandomNumbers::independent ? 1 : samples;
  const std::string name =
      formatted("%s/%s/%s", name_of(choice.light_sampling), name_of(choice.direct), name_of(choice.random));
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { efficiency(state, settings); })
      ->Unit(benchmark::kMillisecond)
      ->Repetitions(5)
      ->ReportAggregatesOnly();
}

}  // namespace

int main(int argc, char** argv) {
  for (const Choice& choice : {Choice{LightPoints::area}, Choice{LightPoints::visible}, Choice{LightPoints::cone},
                               Choice{LightPoints::cone, DirectLighting::mis},
                               Choice{LightPoints::cone, DirectLighting::light, RandomNumbers::stratified},
                               Choice{LightPoints::cone, DirectLighting::light, RandomNumbers::sobol},
                               Choice{LightPoints::cone, DirectLighting::mis, RandomNumbers::sobol}})
    add(choice);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}

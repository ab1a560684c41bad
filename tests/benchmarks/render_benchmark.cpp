// Camera paths and rays a second of the built-in scenes, on one thread, in double and in packets of every width that this machine
// has; and how much of the machine's peak, measured in the same run by fused multiply-adds that wait for nothing, the
// intersector's useful operations are.
#include <array>
#include <bit>
#include <string>

#include <benchmark/benchmark.h>

#include <fairlight/estimators/sphere_directions.h>
#include <fairlight/render/instruction_sets.h>
#include <fairlight/render/render_image.h>

namespace {

using namespace fairlight;

void render(benchmark::State& state, RenderSettings settings, const std::string& instructions) {
  const View view = built_in_scene(settings.scene);
  // So many that the film costs little of it; the thousand lights take a hundred times as long.
  const std::uint64_t samples = settings.real == Arithmetic::doubles || settings.scene == "many-lights" ? 2 : 64;
  double paths = 0, rays = 0;
  for (auto _ : state) {
    Film film(settings.width, settings.height);
    const RenderCost cost = render_image(view, settings, 1, {0, samples}, 1, film, {}, instructions);
    paths += static_cast<double>(cost.paths);
    rays += static_cast<double>(cost.rays);
  }
  state.counters["paths"] = benchmark::Counter(paths, benchmark::Counter::kIsRate);
  state.counters["rays"] = benchmark::Counter(rays, benchmark::Counter::kIsRate);
}

void add_scene(const std::string& scene) {
  RenderSettings settings;
  settings.scene = scene;
  settings.roulette = RouletteKind::throughput;
  settings.roulette_depth = 3;
  const auto add = [&](const std::string& name, const std::string& instructions) {
    benchmark::RegisterBenchmark((scene + "/" + name).c_str(),
                                 [=](benchmark::State& state) { render(state, settings, instructions); })
        ->Unit(benchmark::kMillisecond)
        ->Repetitions(5)
        ->ReportAggregatesOnly();
  };
  settings.real = Arithmetic::doubles;
  add(name_of(settings.real), "");
  settings.real = Arithmetic::packets;
  for (const InstructionSet& set : instruction_sets()) {
    if (set.runs_here) add(set.name, set.name);
  }
}

// Twelve chains, as many as there are registers for: two operations a lane each.
void fused_multiply_adds(benchmark::State& state) {
  std::array<Packet, 12> x;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = Packet(static_cast<float>(i));
  const Packet a(0.999F), b(1e-3F);
  constexpr int rounds = 10'000;
  for (auto _ : state) {
    for (int i = 0; i < rounds; ++i) {
      for (Packet& chain : x) chain = xsimd::fma(chain, a, b);
    }
    benchmark::DoNotOptimize(x);
  }
  const double operations = 2.0 * lanes<Packet> * static_cast<double>(x.size()) * rounds;
  state.counters["flop"] =
      benchmark::Counter(operations * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

// The useful operations of a ray against a sphere of which one side is looked at, in curvature form: 3 subtractions, 3 + 3 for the
// gradient and the sum of normals, 5 + 5 for two products of vectors, 3 for the discriminant, a root, a sum, 2 products that compare
// fractions, 2 comparisons.
constexpr double operations_a_sphere = 3 + 6 + 3 + 5 + 5 + 3 + 1 + 1 + 2 + 2;

void intersect(benchmark::State& state) {
  const View view = built_in_scene("cornell-simple");
  const Geometry<Packet> geometry(view.scene);
  const StreamKey key(1, "benchmark");
  PhiloxStream<Packet> source(key, 0, 0);
  std::array<Ray<Packet>, 64> rays;
  for (Ray<Packet>& ray : rays) {
    ray = {Vec3<Packet>(Packet(50), Packet(40), Packet(80)),
           UniformSphere<Packet>().sample({source.next(), source.next()}), Packet(-1)};
  }
  for (auto _ : state) {
    Packet sum(0);
    for (const Ray<Packet>& ray : rays) sum += geometry.intersect(ray).distance;
    benchmark::DoNotOptimize(sum);
  }
  const double traced = static_cast<double>(state.iterations()) * static_cast<double>(rays.size() * lanes<Packet>);
  state.counters["rays"] = benchmark::Counter(traced, benchmark::Counter::kIsRate);
  state.counters["flop"] =
      benchmark::Counter(traced * operations_a_sphere * static_cast<double>(view.scene.surfaces().size()),
                         benchmark::Counter::kIsRate);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::RegisterBenchmark("fused multiply-adds", fused_multiply_adds)->Repetitions(5)->ReportAggregatesOnly();
  benchmark::RegisterBenchmark("intersect cornell-simple", intersect)->Repetitions(5)->ReportAggregatesOnly();
  for (const std::string& scene : scene_names()) add_scene(scene);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}

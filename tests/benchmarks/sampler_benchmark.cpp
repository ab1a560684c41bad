// How many draws a second each sampler gives, its random numbers included, in double and in packets: compare the two rates of one
// run. Built for the machine that it runs on, so that packets are as wide as they get.
#include <benchmark/benchmark.h>

#include <fairlight/estimators/blackman_harris_filter.h>
#include <fairlight/estimators/concepts.h>
#include <fairlight/estimators/cone.h>
#include <fairlight/estimators/filter.h>
#include <fairlight/estimators/gaussian_filter.h>
#include <fairlight/estimators/ggx.h>
#include <fairlight/estimators/hemisphere.h>
#include <fairlight/estimators/lens.h>
#include <fairlight/estimators/lobe.h>
#include <fairlight/estimators/sphere_directions.h>
#include <fairlight/estimators/sphere_light.h>
#include <fairlight/estimators/stream.h>

namespace {

using namespace fairlight;

constexpr std::uint64_t draws = 1 << 16;
constexpr std::uint64_t a_stream = 4;  // draws from each stream, as a path takes several

template <class Law>
void draw(benchmark::State& state, const Law& law) {
  using Real = typename Law::Scalar;
  const StreamKey key(1, "benchmark");
  for (auto _ : state) {
    auto sum = zero<typename Law::Point>();
    for (std::uint64_t i = 0; i < draws / a_stream; i += lanes<Real>) {
      PhiloxStream<Real> source(key, 0, i);
      for (std::uint64_t k = 0; k < a_stream; ++k) sum += law.sample(next_pair<Real>(source));
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(draws));
}

template <class Make>
void compare(const std::string& name, const Make& make) {
  const auto add = [&]<class Real>(std::type_identity<Real> real, const std::string& kind) {
    const auto law = make(real);
    benchmark::RegisterBenchmark((name + "/" + kind).c_str(), [law](benchmark::State& state) { draw(state, law); })
        ->Repetitions(5)
        ->ReportAggregatesOnly();
  };
  add(std::type_identity<double>{}, "double");
  add(std::type_identity<Packet>{}, "packet");
}

}  // namespace

int main(int argc, char** argv) {
  compare("uniform hemisphere", []<class Real>(std::type_identity<Real>) { return UniformHemisphere<Real>(); });
  compare("cosine hemisphere", []<class Real>(std::type_identity<Real>) { return CosineHemisphere<Real>(); });
  compare("uniform sphere", []<class Real>(std::type_identity<Real>) { return UniformSphere<Real>(); });
  compare("cone", []<class Real>(std::type_identity<Real>) { return UniformCone<Real>(Real(0.25)); });
  compare("power-cosine lobe", []<class Real>(std::type_identity<Real>) {
    return PowerCosineLobe<Real>(Vec3<Real>(Real(0.6f), Real(0), Real(0.8f)), Real(20));
  });
  compare("GGX visible normals", []<class Real>(std::type_identity<Real>) {
    return GgxVisibleNormals<Real>({Real(0.25), Real(0.5)}, Vec3<Real>(Real(0.6f), Real(0), Real(0.8f)));
  });
  compare("sphere by area",
          []<class Real>(std::type_identity<Real>) { return UniformSphereArea<Real>(Real(2.5)); });
  compare("box filter", []<class Real>(std::type_identity<Real>) { return BoxFilter<Real>(); });
  compare("tent filter", []<class Real>(std::type_identity<Real>) { return TentFilter<Real>(); });
  compare("Gaussian filter",
          []<class Real>(std::type_identity<Real>) { return GaussianFilter<Real>(Real(0.5), Real(1)); });
  compare("Blackman-Harris filter",
          []<class Real>(std::type_identity<Real>) { return BlackmanHarrisFilter<Real>(Real(1.5)); });
  compare("circular aperture",
          []<class Real>(std::type_identity<Real>) { return CircularAperture<Real>(Real(2.5)); });
  compare("hexagonal aperture",
          []<class Real>(std::type_identity<Real>) { return PolygonalAperture<Real>(Real(2.5), 6); });
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}

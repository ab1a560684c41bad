// How many bounces a second each surface gives, its random numbers included, in double and in packets: compare the two rates of one
// run. Built for the machine that it runs on, so that packets are as wide as they get.
#include <array>

#include <benchmark/benchmark.h>

#include <fairlight/estimators/concepts.h>
#include <fairlight/estimators/conductor.h>
#include <fairlight/estimators/dielectric.h>
#include <fairlight/estimators/energy_compensation.h>
#include <fairlight/estimators/glossy.h>
#include <fairlight/estimators/hemisphere.h>
#include <fairlight/estimators/lambertian.h>
#include <fairlight/estimators/mixture.h>
#include <fairlight/estimators/stream.h>

namespace {

using namespace fairlight;

constexpr std::uint64_t bounces = 1 << 16;
constexpr std::uint64_t a_stream = 4;  // bounces from each stream, as a path takes several

/// Where surfaces are seen from: drawn beforehand, and many, lest a mirror's bounce be known before it is asked for.
template <class Real>
std::array<Vec3<Real>, 64> views() {
  PhiloxStream<Real> source(StreamKey(1, "views"), 0, 0);
  std::array<Vec3<Real>, 64> outs;
  for (Vec3<Real>& out : outs) out = CosineHemisphere<Real>().sample(next_pair<Real>(source));
  return outs;
}

template <Bsdf Surface>
void bounce(benchmark::State& state, const Surface& surface) {
  using Real = typename Surface::Scalar;
  const StreamKey key(1, "benchmark");
  const auto outs = views<Real>();
  for (auto _ : state) {
    Vec3<Real> directions = zero<Vec3<Real>>();
    Rgb<Real> weights = zero<Rgb<Real>>();
    for (std::uint64_t i = 0; i < bounces / a_stream; i += lanes<Real>) {
      PhiloxStream<Real> source(key, 0, i);
      for (std::uint64_t k = 0; k < a_stream; ++k) {
        Eigen::Matrix<Real, Surface::dimensions, 1> u;
        for (int d = 0; d < Surface::dimensions; ++d) u[d] = source.next();
        const Bounce<Real> sample = surface.sample(outs[(i / lanes<Real> * a_stream + k) % outs.size()], u);
        directions += sample.in;
        weights += sample.weight;
      }
    }
    benchmark::DoNotOptimize(directions);
    benchmark::DoNotOptimize(weights);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(bounces));
}

template <class Make>
void compare(const std::string& name, const Make& make) {
  const auto add = [&]<class Real>(std::type_identity<Real> real, const std::string& kind) {
    const auto surface = make(real);
    benchmark::RegisterBenchmark((name + "/" + kind).c_str(), [surface](auto& state) { bounce(state, surface); })
        ->Repetitions(5)
        ->ReportAggregatesOnly();
  };
  add(std::type_identity<double>{}, "double");
  add(std::type_identity<Packet>{}, "packet");
}

template <class Real>
Rgb<Real> colour(double red, double green, double blue) {
  return {rounded<Real>(red), rounded<Real>(green), rounded<Real>(blue)};
}

}  // namespace

int main(int argc, char** argv) {
  compare("Lambertian",
          []<class Real>(std::type_identity<Real>) { return Lambertian<Real>(colour<Real>(0.75, 0.5, 0.25)); });
  compare("glossy", []<class Real>(std::type_identity<Real>) {
    return Glossy<Real>(colour<Real>(0.75, 0.5, 0.25), Real(20));
  });
  compare("rough conductor", []<class Real>(std::type_identity<Real>) {
    return RoughConductor<Real>({Real(0.25), Real(0.5)}, ConstantReflectance<Real>(colour<Real>(1, 0.75, 0.25)));
  });
  compare("energy-compensated conductor", []<class Real>(std::type_identity<Real>) {
    return EnergyCompensatedConductor<Real>(0.5, ConstantReflectance<Real>(colour<Real>(1, 0.75, 0.25)));
  });
  compare("mirror",
          []<class Real>(std::type_identity<Real>) { return Mirror<Real>(colour<Real>(0.75, 0.5, 0.25)); });
  compare("conductor", []<class Real>(std::type_identity<Real>) {
    return Conductor<Real>(colour<Real>(0.2, 0.9, 1.5), colour<Real>(3.9, 2.5, 1.9));
  });
  compare("dielectric", []<class Real>(std::type_identity<Real>) { return Dielectric<Real>(Real(1.5)); });
  compare("mixture", []<class Real>(std::type_identity<Real>) {
    const WeightedLobe glossy{Glossy<Real>(colour<Real>(0.5, 0.5, 0.5), Real(20)), Real(0.5), Real(0.5)};
    return Mixture(glossy, WeightedLobe{Lambertian<Real>(colour<Real>(0.75, 0.5, 0.25)), Real(0.5), Real(0.5)});
  });
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}

// How many bounces a second each surface gives, its random numbers included, in double and in packets: compare the two rates of one
// run. Built for the machine that it runs on, so that packets are as wide as they get.
#include <array>

#include <benchmarks/rates.h>

#include <fairlight/estimators/conductor.h>
#include <fairlight/estimators/dielectric.h>
#include <fairlight/estimators/energy_compensation.h>
#include <fairlight/estimators/glossy.h>
#include <fairlight/estimators/hemisphere.h>
#include <fairlight/estimators/lambertian.h>
#include <fairlight/estimators/mixture.h>

namespace {

using namespace fairlight;

/// Where surfaces are seen from: drawn beforehand, and many, lest a mirror's bounce be known before it is asked for.
template <class Real>
std::array<Vec3<Real>, 64> views() {
  PhiloxStream<Real> source(StreamKey(1, "views"), 0, 0);
  std::array<Vec3<Real>, 64> outs;
  for (Vec3<Real>& out : outs) out = CosineHemisphere<Real>().sample(next_pair<Real>(source));
  return outs;
}

template <Bsdf Surface>
auto bounces_off(const Surface& surface) {
  using Real = typename Surface::Scalar;
  return [surface, outs = views<Real>(), next = std::size_t{0}](PhiloxStream<Real>& source) mutable {
    Eigen::Matrix<Real, Surface::dimensions, 1> u;
    for (Real& number : u) number = source.next();
    const Bounce<Real> bounce = surface.sample(outs[next++ % outs.size()], u);
    return Vec3<Real>(bounce.in + bounce.weight.matrix());
  };
}

template <class Make>
void compare(const std::string& name, const Make& make) {
  benchmarks::compare(name, [&]<class Real>(std::type_identity<Real> real) { return bounces_off(make(real)); });
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

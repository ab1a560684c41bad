// How many draws a second each sampler gives, its random numbers included, in double and in packets: compare the two rates of one
// run. Built for the machine that it runs on, so that packets are as wide as they get.
#include <benchmarks/rates.h>

#include <fairlight/estimators/blackman_harris_filter.h>
#include <fairlight/estimators/cone.h>
#include <fairlight/estimators/filter.h>
#include <fairlight/estimators/gaussian_filter.h>
#include <fairlight/estimators/ggx.h>
#include <fairlight/estimators/hemisphere.h>
#include <fairlight/estimators/lens.h>
#include <fairlight/estimators/lobe.h>
#include <fairlight/estimators/sphere_directions.h>
#include <fairlight/estimators/uniform_sphere_area.h>

namespace {

using namespace fairlight;

template <class Make>
void compare(const std::string& name, const Make& make) {
  benchmarks::compare(name, [&]<class Real>(std::type_identity<Real> real) {
    return [law = make(real)](PhiloxStream<Real>& source) { return law.sample(next_pair<Real>(source)); };
  });
}

}  // namespace

int main(int argc, char** argv) {
  compare("uniform hemisphere", []<class Real>(std::type_identity<Real>) { return UniformHemisphere<Real>(); });
  compare("cosine hemisphere", []<class Real>(std::type_identity<Real>) { return CosineHemisphere<Real>(); });
  compare("uniform sphere", []<class Real>(std::type_identity<Real>) { return UniformSphere<Real>(); });
  compare("cone", []<class Real>(std::type_identity<Real>) { return UniformCone<Real>(Real(0.25)); });
  compare("power-cosine lobe", []<class Real>(std::type_identity<Real>) {
    return PowerCosineLobe<Real>(Vec3<Real>(rounded<Real>(0.6), Real(0), rounded<Real>(0.8)), Real(20));
  });
  compare("GGX visible normals", []<class Real>(std::type_identity<Real>) {
    return GgxVisibleNormals<Real>({Real(0.25), Real(0.5)},
                                   Vec3<Real>(rounded<Real>(0.6), Real(0), rounded<Real>(0.8)));
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

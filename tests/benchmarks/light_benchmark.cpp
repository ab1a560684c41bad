// How many directions to a light a second each strategy gives, and how many choices among lights, in double and in packets.
// Built for the machine that it runs on, so that packets are as wide as they get.
#include <benchmarks/rates.h>

#include <fairlight/estimators/choose_light.h>
#include <fairlight/estimators/environment.h>
#include <fairlight/estimators/rectangle_light.h>
#include <fairlight/estimators/sphere_sampling.h>

namespace {

using namespace fairlight;

template <class Real>
Vec3<Real> vector(double x, double y, double z) {
  return {rounded<Real>(x), rounded<Real>(y), rounded<Real>(z)};
}

// Directions from a point that the compiler cannot know, as each vertex of a path is another.
template <class Real, class Light>
auto directions_to(const Light& light) {
  return [light](auto& source) {
    Vec3<Real> from = vector<Real>(0.5, -0.25, 0.125);
    benchmark::DoNotOptimize(from);
    const LightSample<Real> sample = light.sample(from, next_pair<Real>(source));
    return Vec3<Real>(sample.direction + Vec3<Real>::Constant(sample.distance + sample.density.value()));
  };
}

template <template <class> class Strategy>
void compare_sphere(const std::string& name) {
  benchmarks::compare(name, []<class Real>(std::type_identity<Real>) {
    return directions_to<Real>(Strategy<Real>(SphereLight<Real>(vector<Real>(3, 4, 12), Real(1))));
  });
}
template <class Real>
using ByArea = SphereByArea<Real>;
template <class Real>
using ByVisibleHemisphere = SphereByVisibleHemisphere<Real>;

template <template <class> class Strategy>
void compare_rectangle(const std::string& name) {
  benchmarks::compare(name, []<class Real>(std::type_identity<Real>) {
    return directions_to<Real>(Strategy<Real>(
        RectangleLight<Real>(vector<Real>(-0.5, 0.25, 1.5), vector<Real>(2, 0, 0), vector<Real>(0, 1.5, 0))));
  });
}

// What a choice gives, as a number.
double number(int i) { return i; }
Packet number(const Index<Packet>& i) { return xsimd::to_float(i); }

template <class Real, class Choice>
Real pick(const Choice& choice, PhiloxStream<Real>& source) {
  const Pick<Real> chosen = choice.sample(next_pair<Real>(source));
  return number(chosen.index) + chosen.probability.value();
}

std::vector<double> powers(int n) {
  std::vector<double> all;
  for (int i = 0; i < n; ++i) all.push_back(i % 3 == 2 ? 0 : i % 7 + 1);
  return all;
}

// Of lights in a row, by their power over the square of their distance from a point that differs from lane to lane.
template <class Real>
auto contribution_among(int n) {
  return [n](PhiloxStream<Real>& source) {
    const Real x = source.next();
    const auto weight = [x](int i) {
      const Real away = x - rounded<Real>(2 * i - 5);
      return Real(rounded<Real>(i % 7 + 1) / (away * away + Real(1)));
    };
    return pick<Real>(ContributionChoice<Real, decltype(weight)>(n, weight), source);
  };
}

void compare_choices() {
  benchmarks::compare("one of 1000", []<class Real>(std::type_identity<Real>) {
    return [](PhiloxStream<Real>& source) { return pick<Real>(UniformChoice<Real>(1000), source); };
  });
  benchmarks::compare("one of 1000 by power", []<class Real>(std::type_identity<Real>) {
    return [choice = PowerChoice<Real>(powers(1000))](PhiloxStream<Real>& source) {
      return pick<Real>(choice, source);
    };
  });
  benchmarks::compare("one of 16 by contribution",
                      []<class Real>(std::type_identity<Real>) { return contribution_among<Real>(16); });
}

}  // namespace

int main(int argc, char** argv) {
  compare_sphere<ByArea>("sphere by area");
  compare_sphere<ByVisibleHemisphere>("sphere by visible hemisphere");
  compare_sphere<SphereByCone>("sphere by cone");
  compare_rectangle<RectangleByArea>("rectangle by area");
  compare_rectangle<RectangleBySolidAngle>("rectangle by solid angle");
  benchmarks::compare("constant environment", []<class Real>(std::type_identity<Real>) {
    return directions_to<Real>(ConstantEnvironment<Real>());
  });
  compare_choices();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}

#include <algorithm>
#include <array>
#include <cmath>

#include <fairlight/estimators/glossy.h>
#include <fairlight/estimators/hemisphere.h>
#include <fairlight/estimators/importance.h>
#include <fairlight/estimators/sobol.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/checks/variances.h>
#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/claims/furnace.h>
#include <fairlight/validation/claims/integrals.h>
#include <fairlight/validation/claims/lights.h>

namespace fairlight {
namespace {

/// A draw of the integral of z^2 over the hemisphere, 2 pi / 3. With uniform directions it is 2 pi
/// z^2, of variance 4 pi^2 (1/5 - 1/9). With cosine-weighted ones it is pi z, of variance pi^2
/// (1/2 - 4/9): 45/288 of the former.
template <template <class> class Directions>
auto squared_cosine() {
  return [](auto& source) {
    const Importance estimator(Directions<double>{}, [](const Vec3<double>& w) { return w.z() * w.z(); });
    return estimator.estimate(source);
  };
}

Claim cosine_against_uniform() {
  constexpr double pi = std::numbers::pi * (1 + 1e-12);
  return variance_claim("variance.cosine_against_uniform", {"CosineHemisphere", "UniformHemisphere"},
                        "elementary; the paper, 3.1", 45.0 / 288, 10,
                        independent_draws("cosine-weighted sampling", squared_cosine<CosineHemisphere>(), 0, pi),
                        independent_draws("uniform sampling", squared_cosine<UniformHemisphere>(), 0, 2 * pi));
}

/// A glossy surface of exponent n seen at 30 degrees under a constant sky. A draw by the lobe is
/// (n + 2) / (n + 1) z. By cosine-weighted directions it is (n + 2) / 2 cos^n(alpha), which is
/// mostly almost zero.
template <template <class> class Directions>
VarianceArm glossy_bounce(const std::string& name, double largest) {
  const auto draw = [](auto& source) {
    const Glossy<double, Directions> surface(Rgb<double>::Ones(), 10);
    return surface.sample({0.5, 0, std::sqrt(0.75)}, next_pair<double>(source)).weight[0];
  };
  return independent_draws(name, draw, 0, largest * (1 + 1e-9));
}

Claim lobe_against_cosine() {
  return variance_claim("variance.lobe_against_cosine", {"Glossy", "PowerCosineLobe", "CosineHemisphere"},
                        "the paper, 3.1 and Fig. 1", 1.0 / 70, 20,
                        glossy_bounce<PowerCosineLobe>("sampling the lobe of a glossy surface", 12.0 / 11),
                        glossy_bounce<CosineHemisphere>("cosine-weighted sampling of it", 6));
}

/// Two sphere lights by two shadow rays: one to each, or twice one to a random one, doubled and
/// averaged. With the means m and m' of the two lights, the latter has (m - m')^2 / 2 more
/// variance, whatever the lights. A ray by cone brings at most the solid angle.
template <class Terms>
VarianceArm shadow_rays(const std::string& name, int times, double factor) {
  const SphereFromOrigin large{{2, 3, 6}, 2};
  const SphereFromOrigin small{{-1, 2, 2}, 0.5};
  const double bounds = std::max(large.cone_bound(), small.cone_bound());
  const auto draw =
      [first = sphere_irradiance_claim<SphereByCone>("", "", large, {0, 0, 1}, bounds).draw,
       second = sphere_irradiance_claim<SphereByCone>("", "", small, {0, 0, 1}, bounds).draw](auto& source) {
        const std::type_identity<double> real;
        return Terms::template sum<double>(
            2, source, [&](int i, auto& numbers) { return i == 0 ? first(real, numbers) : second(real, numbers); });
      };
  return independent_draws(name, draw, 0, factor * bounds * (1 + 1e-9), times);
}

Claim all_lights_against_one() {
  return variance_claim("variance.all_lights_against_one", {"AllLights", "UniformLightSampler", "SphereByCone"},
                        "elementary; the paper, A.1", 1.0 / 28, 20,
                        shadow_rays<AllLights>("a shadow ray to each of two lights", 1, 2),
                        shadow_rays<UniformLightSampler>("two to one of them, weighted by their number,", 2, 2));
}

/// The irradiance from a sphere light, by one shadow ray. By area half of the points face away, and
/// the others face the floor at all angles. By cone directions differ only in their cosine.
template <template <class> class Strategy>
VarianceArm shadow_ray(const std::string& name, double (SphereFromOrigin::*largest)() const) {
  // With sin(a) = 2/7, S = 2 pi (1 - cos(a)) and the centre of the sphere at cos(b) = 6/7 from the
  // normal, the variance by cone is S^2 times that of the cosine over the cone, whose mean is
  // cos(b) (1 + cos(a)) / 2. By area the mean square is the integral of cos^2 A cos_L / t^2 over
  // the cone. With the latter by quadrature the ratio is 0.00225138, 1/444.17.
  const SphereFromOrigin sphere{{2, 3, 6}, 2};
  const auto draw = sphere_irradiance_claim<Strategy>("", "", sphere, {0, 0, 1}, (sphere.*largest)()).draw;
  return independent_draws(
      name, [=](auto& source) { return draw(std::type_identity<double>{}, source); }, 0,
      (sphere.*largest)() * (1 + 1e-9));
}

template <class Real>
using ByArea = SphereByArea<Real>;

Claim cone_against_area() {
  return variance_claim(
      "variance.cone_against_area", {"SphereByCone", "SphereByArea"},
      "Shirley, Wang, Zimmerman 1996; the paper, 3.2", 1.0 / 444, 20,
      shadow_ray<SphereByCone>("a shadow ray in the cone of a sphere light", &SphereFromOrigin::cone_bound),
      shadow_ray<ByArea>("one to its area", &SphereFromOrigin::area_bound));
}

/// The integral of the squared cosine from Sobol' points. A draw pi sqrt(1 - u) falls with u, and n
/// points have one in each interval of length 1/n, so their mean is within pi / n of the integral.
VarianceArm sobol_points_of(std::uint32_t n) {
  const double integral = 2 * std::numbers::pi / 3;
  const double reach = std::numbers::pi / n;
  return replicates_of<OwenSobol<double>>(formatted("%u scrambled points", n), squared_cosine<CosineHemisphere>(),
                                          integral - reach, integral + reach, n);
}

Claim sobol_against_independent() {
  const VarianceArm independent = independent_draws("16 independent ones", squared_cosine<CosineHemisphere>(), 0,
                                                    std::numbers::pi * (1 + 1e-12), 16);
  return variance_claim("variance.sobol_against_independent", {"OwenSobol", "PhiloxStream"}, "Owen 1997", 1.0 / 100,
                        50, sobol_points_of(16), independent);
}

/// The exponent e in variance ~ n^-e is 1 for independent points. Four times the points have 4^-e
/// of the variance.
Claim sobol_convergence() {
  Claim claim = variance_claim("variance.sobol_convergence", {"OwenSobol"}, "Owen 1997", 1.0 / 32, 50,
                               sobol_points_of(64), sobol_points_of(16));
  claim.statement += ": an exponent of 2.5 or more, where independent points have 1";
  claim.check = [check = claim.check](const Trial& trial) {
    Finding finding = check(trial);
    const auto exponent = [](double excess) { return 2.5 - std::log(1 + excess) / std::log(4); };
    finding.note +=
        formatted("; exponent %.3g, at least %.3g", exponent(finding.bias), exponent(finding.interval.hi));
    return finding;
  };
  return claim;
}

/// A furnace of radiance 1 and reflectance 1/2 shows 2. A path with roulette sees N vertices, a
/// geometric number of mean 2 and variance 2. So the mean of 64 has a mean squared error of
/// 2/64 = 1/32. Paths that all end at two vertices, which is the same length, show 1.5, with the
/// squared error 1/4 for any number of paths: eight times as much.
/// Bound    the mean M of 64 such N exceeds 4 with a probability of at most exp(-64 I(4)) = 3e-15,
///          I(4) = 3 ln(3/2) - ln 2 (Chernoff), so E[((M - 2)^2 - 4)+] < 1e-10
Claim roulette_against_fixed_depth() {
  return {.name = "variance.roulette_against_fixed_depth",
          .kind = "variance",
          .subjects = {"RouletteByReflectance", "NoRoulette", "PathTracer"},
          .statement =
              "in a furnace, 64 paths ended by roulette are off by an eighth of the square by which paths of a "
              "fixed depth "
              "and the same length are",
          .source = "geometric series; the paper, 3.2.1",
          .margin_factor = 30,
          .check = [](const Trial& trial) {
            const Furnace furnace;
            Scene grey;
            grey.add_sphere({3, -2, 5}, 7, Rgb<double>(0.5, 0.5, 0.5), Rgb<double>::Ones());
            const TracedScene<double> scene(grey);
            const PathTracer<BouncesBy<CosineHemisphere>, NoDirectLight, RouletteByReflectance<>> tracer;
            const Reference reference{.mean = 1.0 / 32, .lower = 0, .upper = 4, .tail_slack = 1e-10};
            return check_mean(trial, {reference}, [&](auto& source) {
              double sum = 0;
              for (int i = 0; i < 64; ++i) sum += tracer.radiance<double>(scene, furnace.ray, source)[0];
              return (sum / 64 - 2) * (sum / 64 - 2);
            });
          }};
}

}  // namespace

void add_second_order_claims(std::vector<Claim>& claims) {
  claims.push_back(cosine_against_uniform());
  claims.push_back(lobe_against_cosine());
  claims.push_back(cone_against_area());
  claims.push_back(all_lights_against_one());
  claims.push_back(sobol_against_independent());
  claims.push_back(sobol_convergence());
  claims.push_back(roulette_against_fixed_depth());
}

}  // namespace fairlight

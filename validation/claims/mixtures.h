#pragma once

#include <fairlight/estimators/lambertian.h>
#include <fairlight/estimators/mirror.h>
#include <fairlight/estimators/mixture.h>
#include <fairlight/validation/claims/materials.h>

namespace fairlight {

/// The reflectance of a mixture is the sum over its lobes, however they are picked. The mean weight
/// of a bounce is w_1 rho_1 + w_2 rho_2. The mean of the weight times the height of the direction
/// is the integral of f z^2, which for diffuse lobes is 2/3 of this.

namespace detail {

/// The weight of a bounce, and the weight times the height of its direction.
template <class Real>
Vec2<Real> weight_and_height(const Bounce<Real>& bounce) {
  return {bounce.weight[0], Real(bounce.weight[0] * bounce.in.z())};
}

template <class Real>
Rgb<Real> grey(double x) {
  return Rgb<Real>::Constant(rounded<Real>(x));
}

}  // namespace detail

/// Two diffuse lobes, one sampled by the cosine and one uniformly.
/// Bound    f is constant, (w_1 rho_1 + w_2 rho_2) / pi, so the weight is this sum times z / (q_1
///          z + q_2 / 2), largest at z = 1
template <template <class, class> class Mix>
auto two_lambertians(const std::string& name) {
  constexpr double albedo = 0.5 * 0.25 + 0.75 * 0.75;
  constexpr double q = 0.75;
  const auto draw = []<class Real>(std::type_identity<Real>, auto& source) {
    using First = Lambertian<Real>;
    using Second = Lambertian<Real, UniformHemisphere>;
    const WeightedLobe<First> first{First(detail::grey<Real>(0.25)), rounded<Real>(0.5), rounded<Real>(q)};
    const WeightedLobe<Second> second{Second(detail::grey<Real>(0.75)), rounded<Real>(0.75), rounded<Real>(1 - q)};
    const Mix<First, Second> surface(first, second);
    return detail::weight_and_height(detail::bounce(surface, detail::out_at<Real>(1, true), source));
  };
  constexpr double upper = albedo / (q + (1 - q) / 2) * (1 + 1e-12);
  return estimand(name, {"Mixture", "Lambertian", "UniformHemisphere", "CosineHemisphere"},
                  "two diffuse lobes, sampled in two ways, reflect the sum of their albedos, and of their cosines",
                  "elementary: the integral of z^n over the hemisphere is 2 pi / (n + 1)",
                  {{albedo, 0, upper}, {albedo * 2 / 3, 0, upper}}, draw);
}

/// A mirror and a diffuse lobe, seen at the height 0.6. The probabilities of the lobes are not
/// proportional to their reflectances.
template <template <class, class> class Mix>
auto mirror_and_lambertian(const std::string& name) {
  constexpr double z = 0.6;
  constexpr double shiny = 0.25 * 0.75;
  constexpr double diffuse = 0.75 * 0.5;
  constexpr double q = 0.375;
  const auto draw = []<class Real>(std::type_identity<Real>, auto& source) {
    using First = Mirror<Real>;
    using Second = Lambertian<Real>;
    const WeightedLobe<First> first{First(detail::grey<Real>(0.75)), rounded<Real>(0.25), rounded<Real>(q)};
    const WeightedLobe<Second> second{Second(detail::grey<Real>(0.5)), rounded<Real>(0.75), rounded<Real>(1 - q)};
    const Mix<First, Second> surface(first, second);
    return detail::weight_and_height(
        detail::bounce(surface, Vec3<Real>(Real(0), rounded<Real>(0.8), rounded<Real>(z)), source));
  };
  constexpr double upper = diffuse / (1 - q) * (1 + 1e-12);
  return estimand(name, {"Mixture", "Mirror", "Lambertian"},
                  "a mirror and a diffuse lobe reflect the sum of their albedos, and of their cosines",
                  "elementary", {{shiny + diffuse, 0, upper}, {shiny * z + diffuse * 2 / 3, 0, upper}}, draw);
}

/// With probabilities proportional to the reflectances, every bounce has the albedo as its weight:
/// 5/8, from w rho = 1/8 and 1/2.
template <class Real>
auto proportional_mixture() {
  using First = Mirror<Real>;
  using Second = Lambertian<Real>;
  return Mixture<First, Second>({First(detail::grey<Real>(0.5)), rounded<Real>(0.25), rounded<Real>(0.2)},
                                {Second(detail::grey<Real>(1)), rounded<Real>(0.5), rounded<Real>(0.8)});
}

}  // namespace fairlight

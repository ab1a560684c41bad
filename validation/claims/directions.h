#pragma once

#include <fairlight/estimators/cone.h>
#include <fairlight/estimators/importance.h>
#include <fairlight/estimators/lobe.h>
#include <fairlight/validation/checks/law_claims.h>

namespace fairlight {

/// The laws of directions about an axis, and integrals by importance sampling with them. With
/// h = 1 - cos(alpha), the height below the tip of the axis, dw = dh dphi.

/// A cone of 120 degrees half-angle: 1 - cos = 1.5, which floats represent exactly.
template <template <class> class Cone>
auto cone_law() {
  return LawEstimand{"cone.uniform", "UniformCone", "Shirley, Wang, Zimmerman 1996", component<Cone>(1.5),
                     CapDomain(1.5)};
}

/// A power-cosine lobe about a tilted axis.
template <template <class> class Lobe>
auto lobe_law(const std::string& name, double exponent) {
  const Eigen::Vector3d axis(2.0 / 3, -1.0 / 3, 2.0 / 3);
  return LawEstimand{name,
                     "PowerCosineLobe",
                     "Lafortune and Willems 1994",
                     [=]<class Real>(std::type_identity<Real>) {
                       return Lobe<Real>(rounded_vector<Real>(axis), rounded<Real>(exponent));
                     },
                     CapDomain(1, axis),
                     8};
}

/// The integral over a cone of 1 + sin^2(theta) / s, with s = sin^2(theta_max). With
/// H = 1 - cos(theta_max) and sin^2(theta) = 2h - h^2 it is 2 pi (H + (H^2 - H^3/3) / s). The
/// integrand over p is between half of its supremum and the supremum.
template <template <class> class Cone>
auto cone_integral(const std::string& name, double sine_squared) {
  const double height = sine_squared / (1 + std::sqrt(1 - sine_squared));
  const double mean = 2 * std::numbers::pi * height * (1 + height * (1 - height / 3) / sine_squared);
  const auto draw = [=]<class Real>(std::type_identity<Real>, auto& source) {
    const auto largest = rounded<Real>(sine_squared);
    const Importance estimator(Cone<Real>::of_sine_squared(largest), [=](const Vec3<Real>& w) {
      return Real(Real(1) + (w.x() * w.x() + w.y() * w.y()) / largest);
    });
    return estimator.estimate(source);
  };
  return estimand(
      name, {"UniformCone", "Importance"},
      "the integral of 1 + sin^2 / sin^2_max over a cone with sin^2_max = " + std::to_string(sine_squared),
      "elementary", {{mean, 0, 4 * std::numbers::pi * height * (1 + 1e-12)}}, draw);
}

/// The integral of cos^m(alpha) over the directions about an axis is 2 pi / (m + 1). With a lobe of
/// exponent n and m = 3n/2, the integrand over p is at most 2 pi / (n + 1).
template <template <class> class Lobe>
auto lobe_integral(const std::string& name, double exponent) {
  constexpr double tau = 2 * std::numbers::pi;
  const auto draw = [=]<class Real>(std::type_identity<Real>, auto& source) {
    const Vec3<Real> axis(Real(0), rounded<Real>(-0.6), rounded<Real>(0.8));
    const Importance estimator(Lobe<Real>(axis, rounded<Real>(exponent)), [=](const Vec3<Real>& w) {
      using std::exp;
      using std::log1p;
      const Real drop = Vec3<Real>(w - axis).squaredNorm() / Real(2);
      return Real(exp(Real(rounded<Real>(1.5 * exponent) * log1p(-drop))));
    });
    return estimator.estimate(source);
  };
  return estimand(
      name, {"PowerCosineLobe", "Importance"},
      "the integral of cos^(3n/2) over directions by a lobe of exponent n = " + std::to_string(exponent),
      "elementary", {{tau / (1.5 * exponent + 1), 0, tau / (exponent + 1) * (1 + 1e-9)}}, draw);
}

/// The integral of z^2 over all directions is 4 pi / 3; a draw is 4 pi z^2.
template <template <class> class Directions>
auto sphere_integral() {
  const auto draw = []<class Real>(std::type_identity<Real>, auto& source) {
    const Importance estimator(Directions<Real>{}, [](const Vec3<Real>& w) { return Real(w.z() * w.z()); });
    return estimator.estimate(source);
  };
  constexpr double whole = 4 * std::numbers::pi;
  return estimand("importance.sphere.height_squared", {"Importance", "UniformSphere"},
                  "the integral of z^2 over all directions is 4 pi / 3", "elementary",
                  {{whole / 3, 0, whole * (1 + 1e-12)}}, draw);
}

}  // namespace fairlight

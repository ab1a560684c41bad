#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fairlight/validation/checks/parameters.h>
#include <fairlight/validation/claims/integrals.h>

namespace fairlight {

/// An integrand that changes sign and depends on every coordinate of a direction, through every
/// combinator. A combinator that cuts negative draws, or swaps coordinates, cannot keep its mean.

/// The integrand z (c + a x + b y) over the hemisphere. Its integral is pi c, as x and y are odd.
struct SignedIntegrand {
  double a, b, c;

  /// |z (c + a x + b y)| / p is at most `largest` (c + sqrt(a^2 + b^2)), with `largest` that of
  /// z / p.
  Bound bound(double largest) const {
    const double most = largest * (c + std::hypot(a, b));
    return {-most, most};
  }
  double integral() const { return std::numbers::pi * c; }

  template <class Real>
  auto of() const {
    return [a = rounded<Real>(a), b = rounded<Real>(b), c = rounded<Real>(c)](const Vec3<Real>& w) {
      return Real(w.z() * (c + a * w.x() + b * w.y()));
    };
  }
};

/// The coefficients of all rows: a and b are larger than c, so draws have both signs.
inline std::vector<ParameterRange> signed_coefficients(const std::string& component) {
  return {
      {component, "slope along x", 1, 2}, {component, "slope along y", -2, -1}, {component, "constant", 0.5, 1}};
}

/// Importance sampling of the integrand. z / p is at most pi by cosine-weighted directions and 2 pi
/// by uniform ones.
template <template <class> class Directions>
auto signed_importance(const SignedIntegrand& f) {
  constexpr bool by_cosine = std::is_same_v<Directions<double>, CosineHemisphere<double>>;
  return [=]<class Real>(std::type_identity<Real>) {
    return Importance(Directions<Real>{}, f.template of<Real>(), f.bound((by_cosine ? 1 : 2) * std::numbers::pi));
  };
}

/// The estimand of `combine(inner)`, with `inner` the integrand by uniform directions.
template <class Combine>
auto signed_integral(const std::string& name, const std::string& subject, const std::vector<double>& values,
                     const Combine& combine) {
  const SignedIntegrand f{values[0], values[1], values[2]};
  const auto make = [=](auto real) { return combine(signed_importance<UniformHemisphere>(f)(real)); };
  auto integral =
      bounded_experiment(name, {subject}, "the integral of z (c + a x + b y) over the hemisphere is pi c",
                         "elementary: x and y are odd", f.integral(), make);
  integral.margin_factor = 5;  // draws of both signs vary several times as much as their mean
  return integral;
}

/// With z for a control, whose integral is pi.
template <template <class, class> class Variate>
auto signed_control_variate(const std::vector<double>& values) {
  const auto combine = []<class Inner>(const Inner& inner) {
    using Real = typename Inner::Scalar;
    const Importance control(UniformHemisphere<Real>{}, [](const Vec3<Real>& w) { return w.z(); },
                             {0, 2 * std::numbers::pi});
    return Variate<Inner, std::remove_cv_t<decltype(control)>>(inner, control, 0.7, std::numbers::pi);
  };
  return signed_integral("signed.control_variate", "ControlVariate", values, combine);
}

}  // namespace fairlight

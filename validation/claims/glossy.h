#pragma once

#include <cmath>
#include <numbers>

#include <fairlight/estimators/glossy.h>
#include <fairlight/estimators/hemisphere.h>
#include <fairlight/stats/quadrature.h>
#include <fairlight/validation/checks/estimand.h>

namespace fairlight {

/// The reflectance of the modified Phong model of albedo 1, at the angle theta of the outgoing
/// direction. It is 1 at normal incidence. At grazing incidence it is (n + 2) / (2 pi) B((n + 1)/2,
/// 3/2), with Euler's beta function.
inline double glossy_reflectance(double exponent, double theta) {
  // In polar coordinates (alpha, phi) about the mirror direction, an incoming direction has the
  // cosine A + B cos(phi), A = cos(alpha) cos(theta), B = sin(alpha) sin(theta). The integral of
  // its positive part over phi is
  //   2 pi A                             if A >= B, the whole circle: alpha <= 90 degrees - theta;
  //   2 (A psi + sqrt(B^2 - A^2)),       psi = arccos(-A/B), otherwise.
  // The reflectance is (n + 2) / (2 pi) times the integral of this and c^n over c = cos(alpha) in
  // [0,1]. The part c >= sin(theta) gives cos(theta) (1 - sin^(n+2)(theta)).
  const double sine = std::sin(theta);
  const double cosine = std::cos(theta);
  if (sine == 0) return 1;
  const auto arc = [=](double c) {
    const double a = c * cosine;
    const double b = std::sqrt(1 - c * c) * sine;
    const double psi = std::acos(std::max(-a / b, -1.0));
    return std::pow(c, exponent) * 2 * (a * psi + std::sqrt(std::max(b * b - a * a, 0.0)));
  };
  const double cut = integrate_with_steep_ends(arc, 0, sine);
  return cosine * (1 - std::pow(sine, exponent + 2)) + (exponent + 2) / (2 * std::numbers::pi) * cut;
}

/// The weight f cos / p of a bounce has the reflectance as its mean. By the lobe it is albedo
/// (n + 2) / (n + 1) cos(in), by cosine-weighted directions albedo (n + 2) / 2 cos^n(alpha).
/// `largest` is the largest factor of the albedo.
template <template <class> class Surface>
auto glossy_albedo(const std::string& name, double exponent, double theta, double largest) {
  constexpr double albedo = 0.75;
  const auto draw = [=]<class Real>(std::type_identity<Real>, auto& source) {
    const Surface<Real> surface(Rgb<Real>::Constant(Real(albedo)), rounded<Real>(exponent));
    const Vec3<Real> out(rounded<Real>(std::sin(theta)), Real(0), rounded<Real>(std::cos(theta)));
    return Real(surface.sample(out, next_pair<Real>(source)).weight[0]);
  };
  return estimand(name, {"Glossy"},
                  "the weight of a bounce has the reflectance as its mean, at " +
                      std::to_string(std::lround(theta * 180 / std::numbers::pi)) + " degrees",
                  theta == 0 ? "Lafortune and Willems 1994" : "by quadrature",
                  {{albedo * glossy_reflectance(exponent, theta), 0, albedo * largest * (1 + 1e-9)}}, draw);
}

template <class Real>
using LobeGlossy = Glossy<Real, PowerCosineLobe>;
template <class Real>
using CosineGlossy = Glossy<Real, CosineHemisphere>;

/// The rows, which faults share: exponent 5, seen at normal incidence and at 45 degrees.
template <template <class> class Surface>
auto glossy_normal() {
  return glossy_albedo<Surface>("glossy.normal", 5, 0, 7.0 / 6);
}
template <template <class> class Surface>
auto glossy_oblique() {
  return glossy_albedo<Surface>("glossy.oblique", 5, std::numbers::pi / 4, 7.0 / 6);
}

}  // namespace fairlight

#pragma once

#include <cmath>
#include <complex>
#include <numbers>

namespace fairlight {

/// Reflectances of smooth boundaries, by other formulas than those of the estimators.

/// Fresnel's equations in the angles of incidence i and refraction t [rad], with sin t = sin i / n.
/// The mean of the reflectances for polarisation across and along the plane of incidence.
/// Formula  sin^2(i - t) / sin^2(i + t) across, tan^2(i - t) / tan^2(i + t) along; at i = 0 their
///          limit ((n - 1) / (n + 1))^2
/// Source   Born and Wolf, 1.5.2
inline double fresnel_by_angles(double i, double n) {
  if (i == 0) return std::pow((n - 1) / (n + 1), 2);
  if (std::sin(i) >= n) return 1;
  const double t = std::asin(std::sin(i) / n);
  const double across = std::sin(i - t) / std::sin(i + t);
  const double along = std::tan(i - t) / std::tan(i + t);
  return (across * across + along * along) / 2;
}

/// The same for a complex index m, with the complex cosine of t from sin t = sin i / m.
/// Formula  the amplitudes (cos i - m cos t) / (cos i + m cos t) and (m cos i - cos t) / (m cos
///          i + cos t)
/// Source   Born and Wolf, 14.2
inline double fresnel_by_amplitudes(double i, std::complex<double> m) {
  const std::complex<double> sine = std::sin(i) / m;
  const std::complex<double> t = std::sqrt(1.0 - sine * sine);
  const double c = std::cos(i);
  return (std::norm((c - m * t) / (c + m * t)) + std::norm((m * c - t) / (m * c + t))) / 2;
}

/// The reflectance of a smooth dielectric of index n > 1 for diffuse light from outside: the
/// integral of F cos / pi over the hemisphere.
/// Source   Walsh 1926; Duntley 1942
inline double diffuse_reflectance_outside(double n) {
  const double n2 = n * n;
  const double n4 = n2 * n2;
  const double plus = n2 + 1;
  const double minus = n2 - 1;
  return 0.5 + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1)) +
         n2 * minus * minus / std::pow(plus, 3) * std::log((n - 1) / (n + 1)) -
         2 * n2 * n * (n2 + 2 * n - 1) / (plus * (n4 - 1)) +
         8 * n4 * (n4 + 1) / (plus * (n4 - 1) * (n4 - 1)) * std::log(n);
}

/// The same for diffuse light from inside. A ray and its reverse have the same reflectance, F(i,
/// n) = F(t, 1/n), and cos i dw_i = n^2 cos t dw_t. So the share 1 - R that comes in is n^2 times
/// the share that goes out.
/// Source   Duntley 1942
inline double diffuse_reflectance_inside(double n) { return 1 - (1 - diffuse_reflectance_outside(n)) / (n * n); }

}  // namespace fairlight

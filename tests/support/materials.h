#pragma once

#include <cmath>

#include <support/unit_square.h>

namespace fairlight::testing {

/// Log-uniform numbers in [low, high), low > 0.
inline rc::Gen<double> between(double low, double high) {
  return rc::gen::map(unit_number(), [=](double u) { return low * std::pow(high / low, u); });
}

/// Cosines from 1e-6 to 1, including both ends.
inline rc::Gen<double> cosine_to_grazing() {
  return rc::gen::oneOf(between(1e-6, 1), rc::gen::element(1e-6, 0.5, 1.0));
}

/// Indices from 1/3 to 3, including 1 and values near 1.
inline rc::Gen<double> index_of_refraction() {
  const auto above_one = rc::gen::map(between(1e-9, 0.5), [](double x) { return 1 + x; });
  const auto below_one = rc::gen::map(between(1e-9, 0.5), [](double x) { return 1 - x; });
  return rc::gen::oneOf(between(1.0 / 3, 3), above_one, below_one, rc::gen::just(1.0));
}

/// Unit vectors above the surface, down to grazing angles.
inline rc::Gen<Vec3<double>> direction_above() {
  return rc::gen::map(rc::gen::pair(cosine_to_grazing(), unit_number()), [](const std::pair<double, double>& p) {
    const double radius = std::sqrt((1 - p.first) * (1 + p.first));
    const double phi = 2 * pi<double> * p.second;
    return Vec3<double>(radius * std::cos(phi), radius * std::sin(phi), p.first);
  });
}

}  // namespace fairlight::testing

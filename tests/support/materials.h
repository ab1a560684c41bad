#pragma once

#include <cmath>

#include <support/unit_square.h>

namespace fairlight::testing {

/// Numbers in [low, high), low > 0, alike in their logarithm.
inline rc::Gen<double> between(double low, double high) {
  return rc::gen::map(unit_number(), [=](double u) { return low * std::pow(high / low, u); });
}

/// Cosines from 1e-6 to 1, both of them too.
inline rc::Gen<double> cosine_to_grazing() {
  return rc::gen::oneOf(between(1e-6, 1), rc::gen::element(1e-6, 0.5, 1.0));
}

/// From 1/3 to 3; 1 exactly, and near it.
inline rc::Gen<double> index_of_refraction() {
  const auto above_one = rc::gen::map(between(1e-9, 0.5), [](double x) { return 1 + x; });
  const auto below_one = rc::gen::map(between(1e-9, 0.5), [](double x) { return 1 - x; });
  return rc::gen::oneOf(between(1.0 / 3, 3), above_one, below_one, rc::gen::just(1.0));
}

/// Unit vectors above the surface, down to grazing.
inline rc::Gen<Vec3<double>> direction_above() {
  return rc::gen::map(rc::gen::pair(cosine_to_grazing(), unit_number()), [](const std::pair<double, double>& p) {
    const double radius = std::sqrt((1 - p.first) * (1 + p.first));
    const double phi = 2 * pi<double> * p.second;
    return Vec3<double>(radius * std::cos(phi), radius * std::sin(phi), p.first);
  });
}

}  // namespace fairlight::testing

#pragma once

#include <rapidcheck.h>
#include <support/unit_square.h>

#include <fairlight/estimators/ggx.h>

namespace fairlight::testing {

/// Roughness from 1e-4 to 1, log-uniform.
inline rc::Gen<double> roughness() {
  return rc::gen::map(unit_number(), [](double u) { return std::pow(10, -4 * u); });
}

/// Directions above the surface, with z from 1 down to 1e-6.
inline rc::Gen<Vec3<double>> direction_above() {
  return rc::gen::map(unit_point(), [](const Vec2<double>& u) {
    const double z = std::pow(10, -6 * u.x());
    const double sine = std::sqrt((1 - z) * (1 + z));
    return Vec3<double>(sine * std::cos(2 * M_PI * u.y()), sine * std::sin(2 * M_PI * u.y()), z);
  });
}

/// Points of [0,1)^2 in floats.
inline rc::Gen<Vec2<float>> unit_point_float() {
  return rc::gen::map(
      rc::gen::pair(rc::gen::inRange(0, 1 << 24), rc::gen::inRange(0, 1 << 24)), [](const std::pair<int, int>& u) {
        return Vec2<float>(static_cast<float>(u.first) * 0x1p-24f, static_cast<float>(u.second) * 0x1p-24f);
      });
}

/// The corners and edges of [0,1)^2 in floats.
inline std::vector<Vec2<float>> edge_points_float() {
  std::vector<Vec2<float>> points;
  for (float a : {0.0f, 0x1p-24f, 0.5f, 1 - 0x1p-24f}) {
    for (float b : {0.0f, 0x1p-24f, 0.5f, 1 - 0x1p-24f}) points.emplace_back(a, b);
  }
  return points;
}

}  // namespace fairlight::testing

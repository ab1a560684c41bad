#pragma once

#include <array>
#include <string>
#include <vector>

#include <fairlight/validation/checks/parameters.h>
#include <fairlight/validation/claims/lights.h>

namespace fairlight {

/// The irradiance from lights at distances that each run draws anew. The light has the same shape
/// at every distance, so the irradiance does not depend on it. A length constant in the code, such
/// as a floor under a distance, shows in one of three ranges.

struct DistanceRange {
  const char* name;
  double low, high;  // of the distance [m]
};
inline constexpr std::array<DistanceRange, 3> distance_ranges{
    {{"near", 1e-3, 0.09}, {"middle", 0.09, 10}, {"far", 10, 1e4}}};

inline std::vector<ParameterRange> drawn_distance(const std::string& light, const DistanceRange& range) {
  return {{light, "distance", range.low, range.high, ParameterRange::Law::logarithmic},
          {light, "size / distance", 0.25, 1}};
}

/// A rectangle overhead; values are its distance and its size divided by that. `share_of_area` > 0:
/// 1/p is at most this share of the bound by area; 0: at most the solid angle.
template <template <class> class Strategy>
auto rectangle_at_any_distance(const std::string& name, const std::string& subject, double share_of_area,
                               const std::vector<double>& values) {
  const double d = values[0], size = values[1];
  const RectangleFromOrigin rectangle{{-0.3 * size * d, 0.1 * size * d, d}, size * d, 1.5 * size * d};
  const double largest = share_of_area > 0 ? share_of_area * rectangle.area_bound() : rectangle.solid_angle();
  auto light = rectangle_irradiance_claim<Strategy>(name, subject, rectangle, {0, 0, 1}, largest);
  light.margin_factor = 3;
  return light;
}

/// A sphere aslant, wholly above the horizon; values as before, for its radius.
template <template <class> class Strategy>
auto sphere_at_any_distance(const std::string& name, const std::string& subject, double share_of_area,
                            const std::vector<double>& values) {
  const double d = values[0], radius = 0.6 * values[1] * d;
  const SphereFromOrigin sphere{{0.48 * d, 0, 0.8772685 * d}, radius};
  const double largest = share_of_area > 0 ? share_of_area * sphere.area_bound() : sphere.cone_bound();
  auto light = sphere_irradiance_claim<Strategy>(name, subject, sphere, {0, 0, 1}, largest);
  light.margin_factor = 3;
  return light;
}

}  // namespace fairlight

#pragma once

#include <cmath>
#include <numbers>

#include <fairlight/estimators/vec.h>

namespace fairlight {

/// A domain is an image of the unit square that preserves areas up to one constant, `size()`, so that a density
/// integrates over it as over the square, and cells of the square are cells of it.
/// `at(s, t)` is the point of the square's (s, t), `coordinates(x)` the inverse.

/// Directions with z >= 0. Equal heights have equal areas (Archimedes).
struct HemisphereDomain {
  double size() const { return 2 * std::numbers::pi; }
  Vec3<double> at(double s, double t) const {
    const double radius = std::sqrt(1 - s * s);
    const double phi = 2 * std::numbers::pi * (t - 0.5);
    return {radius * std::cos(phi), radius * std::sin(phi), s};
  }
  Vec2<double> coordinates(const Vec3<double>& w) const {
    return {w.z(), std::atan2(w.y(), w.x()) / (2 * std::numbers::pi) + 0.5};
  }
};

/// The surface of a sphere, its points given as unit normals.
struct SphereDomain {
  double radius;

  double size() const { return 4 * std::numbers::pi * radius * radius; }
  Vec3<double> at(double s, double t) const {
    const double z = 2 * s - 1;
    const double ring = std::sqrt(1 - z * z);
    const double phi = 2 * std::numbers::pi * (t - 0.5);
    return {ring * std::cos(phi), ring * std::sin(phi), z};
  }
  Vec2<double> coordinates(const Vec3<double>& n) const {
    return {(n.z() + 1) / 2, std::atan2(n.y(), n.x()) / (2 * std::numbers::pi) + 0.5};
  }
};

/// The rectangle [low, high]^2.
struct SquareDomain {
  double low, high;

  double size() const { return (high - low) * (high - low); }
  Vec2<double> at(double s, double t) const { return {low + (high - low) * s, low + (high - low) * t}; }
  Vec2<double> coordinates(const Vec2<double>& x) const {
    return {(x.x() - low) / (high - low), (x.y() - low) / (high - low)};
  }
};

}  // namespace fairlight

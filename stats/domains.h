#pragma once

#include <cstdint>

#include <Eigen/Core>

namespace fairlight {

/// A domain is an image of the unit square that preserves areas up to one constant, `size()`, so that a density
/// integrates over it as over the square, and cells of the square are cells of it. `at(s, t)` is the point of the
/// square's (s, t); `coordinates(x)` the inverse. A one-dimensional domain ignores t, and gives 1/2 for it. Where t is a turn, `eighths(x)` is
/// the same but for t, of which it gives the middle of its eighth: so much is known without an arc tangent.

/// The interval [low, high]. Points are numbers.
struct IntervalDomain {
  double low, high;

  double size() const { return high - low; }
  double at(double s, double) const { return low + (high - low) * s; }
  Eigen::Vector2d coordinates(double x) const { return {(x - low) / (high - low), 0.5}; }
};

/// The square [low, high]^2.
struct SquareDomain {
  double low, high;

  double size() const { return (high - low) * (high - low); }
  Eigen::Vector2d at(double s, double t) const { return {low + (high - low) * s, low + (high - low) * t}; }
  Eigen::Vector2d coordinates(const Eigen::Vector2d& x) const {
    return {(x.x() - low) / (high - low), (x.y() - low) / (high - low)};
  }
};

/// The disk of the given radius about the origin. Equal steps of r^2 have equal areas.
struct DiskDomain {
  double radius;

  double size() const;
  Eigen::Vector2d at(double s, double t) const;
  Eigen::Vector2d coordinates(const Eigen::Vector2d& x) const;
  Eigen::Vector2d eighths(const Eigen::Vector2d& x) const;
};

/// The regular polygon about the origin with the given number of corners, at the given distance, the first at an angle
/// from +x. Each side and the origin make a triangle: equal steps along the side have equal areas, and equal steps of the
/// squared distance from the origin across it.
struct PolygonDomain {
  double radius;
  int corners;
  double rotation;

  double size() const;
  Eigen::Vector2d at(double s, double t) const;
  Eigen::Vector2d coordinates(const Eigen::Vector2d& x) const;
};

/// Directions with z >= 0, unit vectors. Equal heights have equal areas (Archimedes).
struct HemisphereDomain {
  double size() const;
  Eigen::Vector3d at(double s, double t) const;
  Eigen::Vector2d coordinates(const Eigen::Vector3d& w) const;
  Eigen::Vector2d eighths(const Eigen::Vector3d& w) const;
};

/// Directions about an axis, a unit vector, down to `height` = 1 - cos of the angle to it, in (0,2].
class CapDomain {
 public:
  explicit CapDomain(double height, const Eigen::Vector3d& axis = {0, 0, 1});

  double size() const;
  Eigen::Vector3d at(double s, double t) const;
  Eigen::Vector2d coordinates(const Eigen::Vector3d& w) const;
  Eigen::Vector2d eighths(const Eigen::Vector3d& w) const;

 private:
  double height_;
  Eigen::Matrix3d turned_;
};

/// The directions within 90 degrees of each of two unit vectors, neither equal nor opposite: a lune, whose horns lie
/// on their cross product. Equal heights along that have equal areas, and so have equal angles about it.
class LuneDomain {
 public:
  LuneDomain(const Eigen::Vector3d& first, const Eigen::Vector3d& second);

  double size() const;
  Eigen::Vector3d at(double s, double t) const;
  Eigen::Vector2d coordinates(const Eigen::Vector3d& w) const;

 private:
  Eigen::Vector3d first_, axis_, across_;
  double width_;
};

/// The surface of a sphere, its points given as unit normals.
struct SphereDomain {
  double radius;

  double size() const;
  Eigen::Vector3d at(double s, double t) const;
  Eigen::Vector2d coordinates(const Eigen::Vector3d& n) const;
  Eigen::Vector2d eighths(const Eigen::Vector3d& n) const;
};

/// The numbers 0 .. n-1, whose "density" is a probability; one cell each.
struct DiscreteDomain {
  std::int64_t n;

  double size() const { return static_cast<double>(n); }
  std::int64_t at(double s, double) const { return static_cast<std::int64_t>(s * static_cast<double>(n)); }
  Eigen::Vector2d coordinates(std::int64_t i) const {
    return {(static_cast<double>(i) + 0.5) / static_cast<double>(n), 0.5};
  }
};

}  // namespace fairlight

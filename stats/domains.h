#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace fairlight {

/// A domain is an image of the unit square that preserves areas up to one constant, `size()`, so that a density
/// integrates over it as over the square, and cells of the square are cells of it. `at(s, t)` is the point of the
/// square's (s, t); `coordinates(x)` the inverse. A one-dimensional domain ignores t, and gives 1/2 for it.

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

namespace detail {

/// The fraction of a turn from -x at which the point lies, in [0,1], and the point of the unit circle there.
inline double turn(double x, double y) { return std::atan2(y, x) / (2 * std::numbers::pi) + 0.5; }
inline Eigen::Vector2d on_circle(double turn) {
  const double phi = 2 * std::numbers::pi * (turn - 0.5);
  return {std::cos(phi), std::sin(phi)};
}
inline Eigen::Vector3d at_height(double z, double turn) {
  const Eigen::Vector2d ring = std::sqrt((1 - z) * (1 + z)) * on_circle(turn);
  return {ring.x(), ring.y(), z};
}

}  // namespace detail

/// The disk of the given radius about the origin. Equal steps of r^2 have equal areas.
struct DiskDomain {
  double radius;

  double size() const { return std::numbers::pi * radius * radius; }
  Eigen::Vector2d at(double s, double t) const { return radius * std::sqrt(s) * detail::on_circle(t); }
  Eigen::Vector2d coordinates(const Eigen::Vector2d& x) const {
    return {x.squaredNorm() / (radius * radius), detail::turn(x.x(), x.y())};
  }
};

/// The regular polygon about the origin with the given number of corners, at the given distance, the first at an angle
/// from +x. Each side and the origin make a triangle: equal steps along the side have equal areas, and equal steps of the
/// squared distance from the origin across it.
struct PolygonDomain {
  double radius;
  int corners;
  double rotation;

  double half_sector() const { return std::numbers::pi / corners; }
  double apothem() const { return radius * std::cos(half_sector()); }
  double size() const { return corners * radius * radius * std::sin(2 * half_sector()) / 2; }

  Eigen::Vector2d at(double s, double t) const {
    const double side = std::floor(t * corners);
    const double angle = std::atan((2 * (t * corners - side) - 1) * std::tan(half_sector()));
    return std::sqrt(s) * apothem() / std::cos(angle) *
           (from_first_corner(1) * detail::on_circle((side + 0.5 + angle / (2 * half_sector())) / corners));
  }
  Eigen::Vector2d coordinates(const Eigen::Vector2d& x) const {
    const Eigen::Vector2d turned = from_first_corner(-1) * x;
    const double turn = detail::turn(turned.x(), turned.y()) * corners;
    const double side = std::floor(turn);
    const double angle = (2 * (turn - side) - 1) * half_sector();
    const double out = x.norm() * std::cos(angle) / apothem();
    return {out * out, (side + 0.5 + std::tan(angle) / std::tan(half_sector()) / 2) / corners};
  }

 private:
  // A turn starts at -x.
  Eigen::Matrix2d from_first_corner(double sign) const {
    return Eigen::Rotation2Dd(sign * (rotation - std::numbers::pi)).toRotationMatrix();
  }
};

/// Directions with z >= 0, unit vectors. Equal heights have equal areas (Archimedes).
struct HemisphereDomain {
  double size() const { return 2 * std::numbers::pi; }
  Eigen::Vector3d at(double s, double t) const { return detail::at_height(s, t); }
  Eigen::Vector2d coordinates(const Eigen::Vector3d& w) const { return {w.z(), detail::turn(w.x(), w.y())}; }
};

/// Directions about an axis, a unit vector, down to `height` = 1 - cos of the angle to it, in (0,2].
class CapDomain {
 public:
  explicit CapDomain(double height, const Eigen::Vector3d& axis = {0, 0, 1})
      : height_(height), turned_(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d(0, 0, 1), axis)) {}

  double size() const { return 2 * std::numbers::pi * height_; }
  Eigen::Vector3d at(double s, double t) const { return turned_ * detail::at_height(1 - height_ * s, t); }
  Eigen::Vector2d coordinates(const Eigen::Vector3d& w) const {
    const Eigen::Vector3d local = turned_.transpose() * w;
    const double ring = local.head<2>().squaredNorm();
    const double drop = local.z() > 0 ? ring / (1 + local.z()) : 1 - local.z();  // never negative by rounding
    return {drop / height_, detail::turn(local.x(), local.y())};
  }

 private:
  double height_;
  Eigen::Matrix3d turned_;
};

/// The directions within 90 degrees of each of two unit vectors, neither equal nor opposite: a lune, whose horns lie
/// on their cross product. Equal heights along that have equal areas, and so have equal angles about it.
class LuneDomain {
 public:
  LuneDomain(const Eigen::Vector3d& first, const Eigen::Vector3d& second)
      : first_(first),
        axis_(first.cross(second).normalized()),
        across_(axis_.cross(first)),
        width_(std::numbers::pi - std::acos(first.dot(second))) {}

  double size() const { return 2 * width_; }
  Eigen::Vector3d at(double s, double t) const {
    const double height = 2 * s - 1;
    const double angle = std::numbers::pi / 2 - width_ * t;
    const double radius = std::sqrt((1 - height) * (1 + height));
    return height * axis_ + radius * (std::cos(angle) * first_ + std::sin(angle) * across_);
  }
  Eigen::Vector2d coordinates(const Eigen::Vector3d& w) const {
    const double angle = std::atan2(w.dot(across_), w.dot(first_));
    return {(w.dot(axis_) + 1) / 2, (std::numbers::pi / 2 - angle) / width_};
  }

 private:
  Eigen::Vector3d first_, axis_, across_;
  double width_;
};

/// The surface of a sphere, its points given as unit normals.
struct SphereDomain {
  double radius;

  double size() const { return 4 * std::numbers::pi * radius * radius; }
  Eigen::Vector3d at(double s, double t) const { return detail::at_height(2 * s - 1, t); }
  Eigen::Vector2d coordinates(const Eigen::Vector3d& n) const {
    return {(n.z() + 1) / 2, detail::turn(n.x(), n.y())};
  }
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

#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace fairlight {

/// Returns the cuts, sorted. Throws std::invalid_argument for one outside (0,1).
std::vector<double> checked_cuts(std::vector<double> cuts);

/// Returns the share. Throws std::invalid_argument for one outside (0,1).
double checked_share(double share);

/// A domain maps the unit square onto a set and preserves area up to one constant, `size()`. So a
/// density on the domain can be integrated over the square, and cells of the square are cells of
/// the domain. `at(s, t)` maps the point (s, t) of the square to the domain; `coordinates(x)` is
/// the inverse. A one-dimensional domain ignores t, and its inverse returns t = 1/2. Where t is an
/// angle in turns, `eighths(x)` returns the middle of the eighth of a turn that holds t. It needs
/// no arc tangent. An unbounded domain has `jacobian(s, t)`, the derivative of at(), in place of
/// size().

template <class Domain>
struct CutDomain;

/// The interval [low, high]. Points are numbers.
struct IntervalDomain {
  double low, high;
  static constexpr bool is_line = true;

  /// The same interval, cut where the density jumps or has an integrable pole (domain_options.h).
  /// Throws std::invalid_argument for a cut outside (low, high).
  CutDomain<IntervalDomain> cut_at(const std::vector<double>& x) const;
  double size() const { return high - low; }
  double at(double s, double) const { return low + (high - low) * s; }
  Eigen::Vector2d coordinates(double x) const { return {(x - low) / (high - low), 0.5}; }
};

/// All real numbers. Half of the unit interval's cells lie within `scale` of `centre`.
struct LineDomain {
  double centre = 0, scale = 1;
  static constexpr bool is_line = true;

  double at(double s, double) const;
  double jacobian(double s, double) const;
  Eigen::Vector2d coordinates(double x) const;
};

/// The numbers from `low` upwards. Half of the unit interval's cells lie within `scale` of `low`.
struct HalfLineDomain {
  double low = 0, scale = 1;
  static constexpr bool is_line = true;

  double at(double s, double) const;
  double jacobian(double s, double) const;
  Eigen::Vector2d coordinates(double x) const;
};

/// The square [low, high]^2.
struct SquareDomain {
  double low, high;

  /// The same square, cut along lines of constant x and of constant y, as IntervalDomain is.
  CutDomain<SquareDomain> cut_at(const std::vector<double>& x, const std::vector<double>& y) const;
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

/// A regular polygon about the origin. `radius` is the distance of its corners, `rotation` the
/// angle of the first corner from +x. Each side makes a triangle with the origin: equal steps along
/// the side have equal areas, and so have equal steps of the squared distance of a line parallel to
/// the side.
struct PolygonDomain {
  double radius;
  int corners;
  double rotation;

  double size() const;
  Eigen::Vector2d at(double s, double t) const;
  Eigen::Vector2d coordinates(const Eigen::Vector2d& x) const;
};

/// The hemisphere of unit vectors with z >= 0. Equal heights have equal areas (Archimedes).
struct HemisphereDomain {
  double size() const;
  Eigen::Vector3d at(double s, double t) const;
  Eigen::Vector2d coordinates(const Eigen::Vector3d& w) const;
  Eigen::Vector2d eighths(const Eigen::Vector3d& w) const;
};

/// The spherical cap of unit vectors w with 1 - w.axis <= `height`; the axis is a unit vector,
/// `height` in (0,2].
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

/// A lune: the directions within 90 degrees of both of two unit vectors, which are neither equal
/// nor opposite. Its horns lie along their cross product. Equal heights along the cross product
/// have equal areas, and so have equal angles about it.
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

/// The surface of a sphere; its points are given as unit normals.
struct SphereDomain {
  double radius;

  double size() const;
  Eigen::Vector3d at(double s, double t) const;
  Eigen::Vector2d coordinates(const Eigen::Vector3d& n) const;
  Eigen::Vector2d eighths(const Eigen::Vector3d& n) const;
};

/// The integers 0 .. n-1. The "density" is a probability, and each integer is a cell.
struct DiscreteDomain {
  std::int64_t n;
  static constexpr bool is_line = true;

  double size() const { return static_cast<double>(n); }
  std::int64_t at(double s, double) const { return static_cast<std::int64_t>(s * static_cast<double>(n)); }
  Eigen::Vector2d coordinates(std::int64_t i) const {
    return {(static_cast<double>(i) + 0.5) / static_cast<double>(n), 0.5};
  }
};

}  // namespace fairlight

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <Eigen/Geometry>

#include <fairlight/stats/domain_options.h>
#include <fairlight/stats/domains.h>

namespace fairlight {
namespace {

constexpr double pi = std::numbers::pi;

// The angle from -x as a fraction of a turn, in [0,1]. on_circle is its inverse.
double turn(double x, double y) { return std::atan2(y, x) / (2 * pi) + 0.5; }
// The middle of the eighth of a turn that holds the point, without a branch; NaN for a NaN.
double eighth_of_turn(double x, double y) {
  // A point with y < 0 is rotated by half a turn.
  const double forward = std::copysign(1, y) * x, up = std::abs(y);
  const int eighth = 4 * !std::signbit(y) + (up >= forward) + (forward <= 0) + (up <= -forward);
  return std::isnan(x + y) ? x + y : (eighth + 0.5) / 8;
}
Eigen::Vector2d on_circle(double turn) {
  const double phi = 2 * pi * (turn - 0.5);
  return {std::cos(phi), std::sin(phi)};
}
Eigen::Vector3d at_height(double z, double turn) {
  const Eigen::Vector2d ring = std::sqrt((1 - z) * (1 + z)) * on_circle(turn);
  return {ring.x(), ring.y(), z};
}

// 1 - z of a unit vector, in a form that rounding never makes negative.
double drop(const Eigen::Vector3d& w) { return w.z() > 0 ? w.head<2>().squaredNorm() / (1 + w.z()) : 1 - w.z(); }

std::vector<double> relative(std::vector<double> x, double low, double high) {
  for (double& cut : x) cut = (cut - low) / (high - low);
  return x;
}

double half_sector(const PolygonDomain& polygon) { return pi / polygon.corners; }
double apothem(const PolygonDomain& polygon) { return polygon.radius * std::cos(half_sector(polygon)); }

// Rotates the axes so that the first corner lies on -x, where turn() starts, or back.
Eigen::Matrix2d from_first_corner(const PolygonDomain& polygon, double sign) {
  return Eigen::Rotation2Dd(sign * (polygon.rotation - pi)).toRotationMatrix();
}

}  // namespace

std::vector<double> checked_cuts(std::vector<double> cuts) {
  for (double cut : cuts) {
    if (!(cut > 0 && cut < 1))
      throw std::invalid_argument(
          "a cut must lie inside the domain (leave out its ends, where quadrature never asks)");
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

double checked_share(double share) {
  if (share > 0 && share < 1) return share;
  throw std::invalid_argument("the share of lost draws must be in (0,1) (give the domain alone if none is lost)");
}

CutDomain<IntervalDomain> IntervalDomain::cut_at(const std::vector<double>& x) const {
  return fairlight::cut_at(*this, relative(x, low, high));
}
CutDomain<SquareDomain> SquareDomain::cut_at(const std::vector<double>& x, const std::vector<double>& y) const {
  return fairlight::cut_at(*this, relative(x, low, high), relative(y, low, high));
}

// x = centre + scale w / (1 - |w|), w = 2s - 1; min(s, 1 - s) keeps the digits of 1 - |w|.
double LineDomain::at(double s, double) const { return centre + scale * (2 * s - 1) / (2 * std::min(s, 1 - s)); }
double LineDomain::jacobian(double s, double) const {
  const double room = std::min(s, 1 - s);
  return scale / (2 * room * room);
}
Eigen::Vector2d LineDomain::coordinates(double x) const {
  const double z = (x - centre) / scale;
  if (!std::isfinite(z)) return {std::numeric_limits<double>::quiet_NaN(), 0.5};
  // Each without cancellation: the tail on the left is s near 0.
  return {z < 0 ? 0.5 / (1 - z) : 1 - 0.5 / (1 + z), 0.5};
}

double HalfLineDomain::at(double s, double) const { return low + scale * s / (1 - s); }
double HalfLineDomain::jacobian(double s, double) const { return scale / ((1 - s) * (1 - s)); }
Eigen::Vector2d HalfLineDomain::coordinates(double x) const {
  const double z = (x - low) / scale;
  return {std::isfinite(z) ? z / (1 + std::max(z, -0.5)) : std::numeric_limits<double>::quiet_NaN(), 0.5};
}

double DiskDomain::size() const { return pi * radius * radius; }
Eigen::Vector2d DiskDomain::at(double s, double t) const { return radius * std::sqrt(s) * on_circle(t); }
Eigen::Vector2d DiskDomain::coordinates(const Eigen::Vector2d& x) const {
  return {x.squaredNorm() / (radius * radius), turn(x.x(), x.y())};
}
Eigen::Vector2d DiskDomain::eighths(const Eigen::Vector2d& x) const {
  return {x.squaredNorm() / (radius * radius), eighth_of_turn(x.x(), x.y())};
}

double PolygonDomain::size() const { return corners * radius * radius * std::sin(2 * half_sector(*this)) / 2; }
Eigen::Vector2d PolygonDomain::at(double s, double t) const {
  const double half = half_sector(*this);
  const double side = std::floor(t * corners);
  const double angle = std::atan((2 * (t * corners - side) - 1) * std::tan(half));
  return std::sqrt(s) * apothem(*this) / std::cos(angle) *
         (from_first_corner(*this, 1) * on_circle((side + 0.5 + angle / (2 * half)) / corners));
}
Eigen::Vector2d PolygonDomain::coordinates(const Eigen::Vector2d& x) const {
  const double half = half_sector(*this);
  const Eigen::Vector2d turned = from_first_corner(*this, -1) * x;
  const double turns = turn(turned.x(), turned.y()) * corners;
  const double side = std::floor(turns);
  const double angle = (2 * (turns - side) - 1) * half;
  const double out = x.norm() * std::cos(angle) / apothem(*this);
  return {out * out, (side + 0.5 + std::tan(angle) / std::tan(half) / 2) / corners};
}

double HemisphereDomain::size() const { return 2 * pi; }
Eigen::Vector3d HemisphereDomain::at(double s, double t) const { return at_height(s, t); }
Eigen::Vector2d HemisphereDomain::coordinates(const Eigen::Vector3d& w) const {
  return {w.z(), turn(w.x(), w.y())};
}
Eigen::Vector2d HemisphereDomain::eighths(const Eigen::Vector3d& w) const {
  return {w.z(), eighth_of_turn(w.x(), w.y())};
}

CapDomain::CapDomain(double height, const Eigen::Vector3d& axis)
    : height_(height), turned_(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d(0, 0, 1), axis)) {}
double CapDomain::size() const { return 2 * pi * height_; }
Eigen::Vector3d CapDomain::at(double s, double t) const { return turned_ * at_height(1 - height_ * s, t); }
Eigen::Vector2d CapDomain::coordinates(const Eigen::Vector3d& w) const {
  const Eigen::Vector3d local = turned_.transpose() * w;
  return {drop(local) / height_, turn(local.x(), local.y())};
}
Eigen::Vector2d CapDomain::eighths(const Eigen::Vector3d& w) const {
  const Eigen::Vector3d local = turned_.transpose() * w;
  return {drop(local) / height_, eighth_of_turn(local.x(), local.y())};
}

LuneDomain::LuneDomain(const Eigen::Vector3d& first, const Eigen::Vector3d& second)
    : first_(first),
      axis_(first.cross(second).normalized()),
      across_(axis_.cross(first)),
      width_(pi - std::acos(first.dot(second))) {}
double LuneDomain::size() const { return 2 * width_; }
Eigen::Vector3d LuneDomain::at(double s, double t) const {
  const double height = 2 * s - 1;
  const double angle = pi / 2 - width_ * t;
  const double radius = std::sqrt((1 - height) * (1 + height));
  return height * axis_ + radius * (std::cos(angle) * first_ + std::sin(angle) * across_);
}
Eigen::Vector2d LuneDomain::coordinates(const Eigen::Vector3d& w) const {
  const double angle = std::atan2(w.dot(across_), w.dot(first_));
  return {(w.dot(axis_) + 1) / 2, (pi / 2 - angle) / width_};
}

double SphereDomain::size() const { return 4 * pi * radius * radius; }
Eigen::Vector3d SphereDomain::at(double s, double t) const { return at_height(2 * s - 1, t); }
Eigen::Vector2d SphereDomain::coordinates(const Eigen::Vector3d& n) const {
  return {(n.z() + 1) / 2, turn(n.x(), n.y())};
}
Eigen::Vector2d SphereDomain::eighths(const Eigen::Vector3d& n) const {
  return {(n.z() + 1) / 2, eighth_of_turn(n.x(), n.y())};
}

}  // namespace fairlight

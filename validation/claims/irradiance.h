#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

namespace fairlight {

/// Irradiances for unit radiance [sr], in closed form: integrals of cos(theta) over the directions
/// that a light fills.

/// The irradiance from a sphere of radius r at the distance d > r, with its centre at the angle
/// theta from the normal.
/// Source   Snyder 1996, "Area light sources for real-time graphics"
inline double sphere_irradiance(double r, double d, double cosine) {
  // The directions fill a cone of half-angle a, sin(a) = r/d. By Lambert's contour formula the
  // integral of the cosine is half that of n . (w x dw) around the visible part of the cone. If the
  // cone is wholly above the horizon, its edge is w = cos(a) c + sin(a) (e cos t + f sin t), with c
  // towards the centre and e upwards across it. Then n . (w x dw) = (sin^2(a) cos(theta) - cos(a)
  // sin(a) sin(theta) cos(t)) dt, and half of its integral over a whole turn is pi sin^2(a)
  // cos(theta).
  // If the horizon cuts the cone, the edge is above it for |t| < T with cos(T) = -cot(a)
  // cot(theta). The horizon closes the contour over the angle 2 psi,
  // cos(psi) = cos(a) / sin(theta), where the integral of n . (w x dw) is the angle itself:
  //   E = sin^2(a) cos(theta) T - cos(a) sin(a) sin(theta) sin(T) + psi.
  const double sin_a = r / d;
  const double cos_a = std::sqrt(1 - sin_a * sin_a);
  if (std::abs(cosine) >= sin_a) return std::numbers::pi * sin_a * sin_a * std::max(cosine, 0.0);
  const double sine = std::sqrt(1 - cosine * cosine);
  const double cut = std::acos(-cos_a / sin_a * cosine / sine);
  const double psi = std::acos(cos_a / sine);
  return sin_a * sin_a * cosine * cut - cos_a * sin_a * sine * std::sin(cut) + psi;
}

/// The irradiance from a polygon wholly above the horizon; `corners` [m] are relative to the point.
/// Formula  |sum g_i m_i . n| / 2 by Lambert's contour formula: edge i subtends the angle g_i in a
///          plane with the unit normal m_i, where w x dw = m_i dg
/// Source   Lambert 1760; Baum, Rushmeier, Winget 1989
inline double polygon_irradiance(const std::vector<Eigen::Vector3d>& corners, const Eigen::Vector3d& normal) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3d& a = corners[i];
    const Eigen::Vector3d& b = corners[(i + 1) % corners.size()];
    const Eigen::Vector3d across = a.cross(b);
    sum += std::atan2(across.norm(), a.dot(b)) * normal.dot(across.normalized());
  }
  return std::abs(sum) / 2;
}

/// The part of a polygon above the horizon, for convex polygons: each edge that crosses the horizon
/// is cut there.
inline std::vector<Eigen::Vector3d> above_horizon(const std::vector<Eigen::Vector3d>& corners,
                                                  const Eigen::Vector3d& normal) {
  std::vector<Eigen::Vector3d> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3d& a = corners[i];
    const Eigen::Vector3d& b = corners[(i + 1) % corners.size()];
    const double height_a = normal.dot(a), height_b = normal.dot(b);
    if (height_a > 0) kept.push_back(a);
    if ((height_a > 0) != (height_b > 0)) kept.push_back(a + height_a / (height_a - height_b) * (b - a));
  }
  return kept;
}

/// The solid angle [sr] of the rectangle [x0, x1] x [y0, y1] in the plane at height z. The integral
/// of z / r^3 up to (x, y) is atan(x y / (z r)).
inline double rectangle_solid_angle(double x0, double x1, double y0, double y1, double z) {
  const auto corner = [z](double x, double y) { return std::atan(x * y / (z * std::hypot(x, y, z))); };
  return corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0);
}

}  // namespace fairlight

#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

namespace fairlight {

/// Irradiances, per unit of radiance [sr], in closed form, each an integral of cos(theta) over the directions that a light fills.

/// A sphere of radius r at the distance d > r, its centre at the angle theta from the normal. Its directions fill a cone of the
/// half-angle a, sin(a) = r/d. By Lambert's contour formula the integral of the cosine is half that of n . (w x dw) around
/// what is seen of the cone.
/// Wholly above the horizon, along the cone's edge w = cos(a) c + sin(a) (e cos t + f sin t), with c towards the centre and e
/// the way up across it, n . (w x dw) = (sin^2(a) cos(theta) - cos(a) sin(a) sin(theta) cos(t)) dt; over a whole turn half of
/// that is pi sin^2(a) cos(theta).
/// Cut by the horizon, the edge is above it for |t| < T with cos(T) = -cot(a) cot(theta), and the horizon closes the contour over
/// the angle 2 psi, cos(psi) = cos(a) / sin(theta), where n . (w x dw) is the angle itself:
///   E = sin^2(a) cos(theta) T - cos(a) sin(a) sin(theta) sin(T) + psi.
/// Source: Snyder 1996, "Area light sources for real-time graphics", whose formula it is.
inline double sphere_irradiance(double r, double d, double cosine) {
  const double sin_a = r / d;
  const double cos_a = std::sqrt(1 - sin_a * sin_a);
  if (std::abs(cosine) >= sin_a) return std::numbers::pi * sin_a * sin_a * std::max(cosine, 0.0);
  const double sine = std::sqrt(1 - cosine * cosine);
  const double cut = std::acos(-cos_a / sin_a * cosine / sine);
  const double psi = std::acos(cos_a / sine);
  return sin_a * sin_a * cosine * cut - cos_a * sin_a * sine * std::sin(cut) + psi;
}

/// A polygon wholly above the horizon, its corners [m] as seen from the point. Each edge subtends an angle g_i in a plane with
/// the unit normal m_i, where w x dw = m_i dg, so Lambert's contour formula gives |sum g_i m_i . n| / 2. Source: Lambert 1760;
/// Baum, Rushmeier, Winget 1989.
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

/// The solid angle [sr] of the rectangle [x0, x1] x [y0, y1] in the plane at height z: at x, y the integral of z / r^3 is
/// atan(x y / (z r)).
inline double rectangle_solid_angle(double x0, double x1, double y0, double y1, double z) {
  const auto corner = [z](double x, double y) { return std::atan(x * y / (z * std::hypot(x, y, z))); };
  return corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0);
}

}  // namespace fairlight

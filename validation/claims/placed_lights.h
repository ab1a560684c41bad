#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <fairlight/validation/checks/parameters.h>
#include <fairlight/validation/claims/lights.h>

namespace fairlight {

/// Lights at drawn places, of drawn sizes and orientations, over a surface that may face anywhere.

namespace detail {

/// The direction of this cosine to the axis, at an angle about it [rad].
inline Vec3<double> direction_about(const Vec3<double>& axis, double cosine, double azimuth) {
  const Vec3<double> x = axis.unitOrthogonal(), y = axis.cross(x);
  const double sine = std::sqrt((1 - cosine) * (1 + cosine));
  return cosine * axis + sine * (std::cos(azimuth) * x + std::sin(azimuth) * y);
}

/// The range of a logarithmic parameter.
inline ParameterRange in_decades(const std::string& component, const std::string& parameter, double low,
                                 double high) {
  return {component, parameter, low, high, ParameterRange::Law::logarithmic};
}

}  // namespace detail

inline constexpr double full_turn_of_light = 2 * std::numbers::pi;

/// A rectangle, and a point of a surface that it lights. From the point, its centre is at an angle
/// to both normals; either face of it may be lit, and a part of it may be below the horizon.
struct PlacedRectangle {
  Vec3<double> point, normal;
  Vec3<double> corner, edge_x, edge_y;

  template <class Real>
  RectangleLight<Real> light() const {
    return {rounded_vector<Real>(corner), rounded_vector<Real>(edge_x), rounded_vector<Real>(edge_y)};
  }
  std::vector<Vec3<double>> corners() const {
    const Vec3<double> first = corner - point;
    return {first, first + edge_x, first + edge_x + edge_y, first + edge_y};
  }
  /// The vector from the point to the corner in the axes of the rectangle.
  Vec3<double> corner_in_axes() const {
    const Vec3<double> x = edge_x.normalized(), y = edge_y.normalized(), first = corner - point;
    return {x.dot(first), y.dot(first), x.cross(y).dot(first)};
  }
  double irradiance() const { return polygon_irradiance(above_horizon(corners(), normal), normal); }
  double solid_angle() const {
    const Vec3<double> c = corner_in_axes();
    return rectangle_solid_angle(c.x(), c.x() + edge_x.norm(), c.y(), c.y() + edge_y.norm(), std::abs(c.z()));
  }
  double area_bound() const {
    const Vec3<double> c = corner_in_axes();
    return RectangleFromOrigin{c, edge_x.norm(), edge_y.norm()}.area_bound();
  }

  /// The distance of a plane along a direction, times the cosine there, divided by that of this
  /// plane: 1 for a sample that lies on the rectangle.
  template <class Real>
  Real on_light(const LightSample<Real>& sample) const {
    const Vec3<double> across = edge_x.cross(edge_y).normalized();
    const Real height = rounded<Real>(across.dot(corner - point));
    return sample.distance * (rounded_vector<Real>(across).dot(sample.direction) / height);
  }
};

/// The next 13 values make a rectangle: see `rectangle_ranges`.
inline PlacedRectangle placed_rectangle(DrawnValues& values) {
  const double distance = values.next(), longer = values.next() * distance, shorter = values.next() * longer;
  const bool wide = values.next() < 0.5;
  const double at_light = values.next(), around_light = values.next();
  const double at_surface = values.next(), around_surface = values.next();
  const double height = values.next();
  const Vec3<double> across = detail::direction_about({0, 0, 1}, height, values.next());
  const Vec3<double> x = detail::direction_about(across, 0, values.next());
  const Vec3<double> y = across.cross(x);
  const Vec3<double> to_centre = detail::direction_about(across, at_light, around_light);
  PlacedRectangle placed;
  placed.point = values.next_vector() * distance;
  placed.normal = detail::direction_about(to_centre, at_surface, around_surface);
  placed.edge_x = (wide ? longer : shorter) * x;
  placed.edge_y = (wide ? shorter : longer) * y;
  placed.corner = placed.point + distance * to_centre - placed.edge_x / 2 - placed.edge_y / 2;
  return placed;
}

/// The ranges of a rectangle's distance [m], of its longer side divided by that, and of its shorter
/// side divided by the longer.
struct RectangleRange {
  std::array<double, 2> distance, size, aspect;
};

/// The parameters of a placed rectangle. The cosine at the light has either sign: each face is lit
/// in half of the channels.
inline void add_rectangle_ranges(std::vector<ParameterRange>& ranges, const std::string& light,
                                 const RectangleRange& range, bool front) {
  const std::vector<ParameterRange> more{
      detail::in_decades(light, "distance", range.distance[0], range.distance[1]),
      detail::in_decades(light, "size / distance", range.size[0], range.size[1]),
      detail::in_decades(light, "shorter / longer side", range.aspect[0], range.aspect[1]),
      {light, "which side is longer", 0, 1},
      {light, "cosine at the light", front ? 0.2 : -1, front ? 1 : -0.2},
      {light, "azimuth at the light", 0, full_turn_of_light},
      {light, "cosine at the surface", 0.3, 1},
      {light, "azimuth at the surface", 0, full_turn_of_light},
      {light, "height of the axis", -1, 1},
      {light, "azimuth of the axis", 0, full_turn_of_light},
      {light, "turn about the axis", 0, full_turn_of_light},
      {light, "place / distance", -0.5, 0.5},
      {light, "place / distance", -0.5, 0.5},
      {light, "place / distance", -0.5, 0.5}};
  ranges.insert(ranges.end(), more.begin(), more.end());
}

/// A sphere, and a point of a surface that it lights. The point may lie inside the sphere, or on it.
struct PlacedSphere {
  Vec3<double> point, normal;
  Vec3<double> centre;
  double radius;
  bool on_it = false;

  template <class Real>
  SphereLight<Real> light() const {
    return {rounded_vector<Real>(centre), rounded<Real>(radius), Mask<Real>(on_it)};
  }
  double distance() const { return (centre - point).norm(); }
  bool inside() const { return distance() < radius; }

  /// From inside pi. From the sphere itself the light fills half of all directions: the projected
  /// solid angle of what the horizon leaves of a hemisphere at the angle t is pi (1 + cos t) / 2.
  double irradiance() const {
    const double cosine = normal.dot(centre - point) / distance();
    if (on_it) return std::numbers::pi * (1 + cosine) / 2;
    return inside() ? std::numbers::pi : sphere_irradiance(radius, distance(), cosine);
  }
  double cone_bound() const {
    if (on_it || inside()) return on_it ? 2 * std::numbers::pi : 4 * std::numbers::pi;
    return SphereFromOrigin{centre - point, radius}.cone_bound();
  }
  double area_bound() const { return SphereFromOrigin{centre - point, radius}.area_bound(); }

  /// The distance of the sample from the centre divided by the radius: 1 for one that lies on the
  /// sphere. It is not asked of a sphere that is much smaller than its distance, as rounding then
  /// hides it.
  template <class Real>
  Real on_light(const LightSample<Real>& sample) const {
    if (radius < 0.05 * distance()) return Real(1);
    const Vec3<Real> way = rounded_vector<Real>(centre - point);
    return Vec3<Real>(sample.distance * sample.direction - way).norm() / rounded<Real>(radius);
  }
};

/// Where the point is, seen from a sphere.
enum class PlaceAtSphere { outside, cut, inside, on_it };

/// The next 9 values make a sphere: see `add_sphere_ranges`. For `cut` the cosine at the surface is
/// in units of the sine of the sphere's cone, so that the horizon always cuts the sphere.
inline PlacedSphere placed_sphere(DrawnValues& values, PlaceAtSphere place) {
  const double distance = values.next(), radius = values.next() * distance;
  const double height = values.next();
  const Vec3<double> to_centre = detail::direction_about({0, 0, 1}, height, values.next());
  const double cosine = values.next() * (place == PlaceAtSphere::cut ? radius / distance : 1);
  PlacedSphere placed;
  placed.normal = detail::direction_about(to_centre, cosine, values.next());
  placed.point = values.next_vector() * distance;
  placed.centre = placed.point + distance * to_centre;
  placed.radius = radius;
  placed.on_it = place == PlaceAtSphere::on_it;
  return placed;
}

/// The ranges of the distance of a sphere's centre [m], of the radius divided by that, and of the
/// cosine at the surface.
struct SphereRange {
  std::array<double, 2> distance, size, cosine;
  PlaceAtSphere place = PlaceAtSphere::outside;
};

inline void add_sphere_ranges(std::vector<ParameterRange>& ranges, const std::string& light,
                              const SphereRange& range) {
  const bool cut = range.place == PlaceAtSphere::cut;
  const std::vector<ParameterRange> more{
      detail::in_decades(light, "distance", range.distance[0], range.distance[1]),
      detail::in_decades(light, "size / distance", range.size[0], range.size[1]),
      {light, "height of the axis", -1, 1},
      {light, "azimuth of the axis", 0, full_turn_of_light},
      {light, cut ? "cosine / sine of the cone" : "cosine at the surface", range.cosine[0], range.cosine[1]},
      {light, "azimuth at the surface", 0, full_turn_of_light},
      {light, "place / distance", -0.5, 0.5},
      {light, "place / distance", -0.5, 0.5},
      {light, "place / distance", -0.5, 0.5}};
  ranges.insert(ranges.end(), more.begin(), more.end());
}

}  // namespace fairlight

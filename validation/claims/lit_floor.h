#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fairlight/render/built_in_scenes.h>
#include <fairlight/validation/claims/filter_rule.h>
#include <fairlight/validation/claims/irradiance.h>

namespace fairlight {

/// A diffuse floor, z = 0, seen from straight above by a camera that is focused on it; or in a
/// coloured mirror above the camera, with left and right exchanged. Lamps beside and above the view
/// light it: a sphere, a rectangle parallel to the floor, or both. No two points of the picture,
/// and no two channels, are equal. Paths end before light can reach the floor by the mirror.
/// Formula  L = rho / pi sum Le E, times the colour of the mirror; E = pi (r/d)^2 cos(theta) of the
///          sphere, and of the rectangle by Lambert's contour formula
/// Source   Snyder 1996; Lambert 1760
struct LitFloor {
  bool sphere, rectangle, mirror = false;

  static constexpr double mirror_height = 1.5, image_height = 1.1, radius = 0.3;
  /// The eye is at the mirror's place, or below it.
  Vec3<double> eye() const { return {0.25, -0.125, mirror ? 1.25 : mirror_height}; }
  /// Of the floor from the eye, along the axis [m].
  double distance() const { return 2 * mirror_height - eye().z(); }
  static Vec3<double> centre() { return {-1.1, -0.5, 1.9}; }
  static Vec3<double> corner() { return {0.6, 0.4, 1.7}; }
  static constexpr double edge_x = 0.75, edge_y = 0.5;
  static Rgb<double> albedo() { return {0.8, 0.5, 0.25}; }
  Rgb<double> of_mirror() const { return mirror ? Rgb<double>(0.9, 0.6, 0.3) : Rgb<double>(1, 1, 1); }
  static Rgb<double> of_sphere() { return {0.1, 1, 2e6}; }
  static Rgb<double> of_rectangle() { return {0.04, 2, 1e7}; }

  /// The view; with a lens if its radius is positive [m].
  View view(double lens) const {
    const Rgb<double> none(0, 0, 0);
    Scene scene;
    scene.add_rectangle({-16, -16, 0}, {32, 0, 0}, {0, 32, 0}, albedo(), none);
    if (sphere) scene.add_sphere(centre(), radius, none, of_sphere());
    if (rectangle) scene.add_rectangle(corner(), {edge_x, 0, 0}, {0, edge_y, 0}, none, of_rectangle());
    if (mirror) {
      const Vec3<double> middle(eye().x(), eye().y(), mirror_height);
      scene.add_rectangle(middle - Vec3<double>(0.3, 0.2, 0), {0.6, 0, 0}, {0, 0.4, 0},
                          Material(Material::Kind::mirror, of_mirror(), 1), none);
    }
    const Camera camera({.eye = eye(),
                         .look = {0, 0, mirror ? 1.0 : -1.0},
                         .up = {0, 1, 0},
                         .image_height = image_height,
                         .aperture_radius = lens,
                         .focus_distance = distance(),
                         .blades = 5,
                         .blade_rotation = 0.3});
    return {"lit_floor", scene, camera};
  }

  /// The radiance at a point of the floor.
  Rgb<double> radiance(const Vec3<double>& point) const {
    const Vec3<double> up(0, 0, 1);
    Rgb<double> sum(0, 0, 0);
    if (sphere) {
      const Vec3<double> way = centre() - point;
      sum += of_sphere() * sphere_irradiance(radius, way.norm(), way.z() / way.norm());
    }
    if (rectangle) {
      const Vec3<double> first = corner() - point, x(edge_x, 0, 0), y(0, edge_y, 0);
      sum += of_rectangle() * polygon_irradiance({first, first + x, first + x + y, first + y}, up);
    }
    return albedo() / std::numbers::pi * sum;
  }

  /// The point of the floor that is at (x, y), in pixels from the top left corner of a picture.
  Vec3<double> point(double x, double y, int width, int height) const {
    const double pixel = pixel_size(height), right = (x - width / 2.0) * pixel, up = (height / 2.0 - y) * pixel;
    return {eye().x() + (mirror ? -right : right), eye().y() + up, 0};
  }
  double pixel_size(int height) const { return distance() * image_height / height; }

  /// No shadow ray to each lamp brings more than this times rho Le of the lamp, over a rectangle of
  /// the floor about `middle` that reaches this far along x and y [m].
  /// Bound    of the rectangle by area and by solid angle A h^2 / (pi t^4), t the shortest
  ///          distance; of the sphere by area 4 r^2 / (d - r)^2, and by cone 2 (1 - cos(alpha)),
  ///          sin(alpha) = r / d
  Rgb<double> largest_terms(const Vec3<double>& middle, double reach, bool by_cone) const {
    const auto beyond = [reach](double offset, double size) {
      return std::max(std::abs(offset) - size - reach, 0.0);
    };
    Rgb<double> sum(0, 0, 0);
    if (sphere) {
      const Vec3<double> way = centre() - middle;
      const double d = std::hypot(beyond(way.x(), 0), beyond(way.y(), 0), way.z());
      const double by_area = 4 * radius * radius / ((d - radius) * (d - radius));
      sum += of_sphere() * (by_cone ? 2 * (1 - std::sqrt(1 - radius * radius / (d * d))) : by_area);
    }
    if (rectangle) {
      const Vec3<double> way = corner() + Vec3<double>(edge_x / 2, edge_y / 2, 0) - middle;
      const double d = std::hypot(beyond(way.x(), edge_x / 2), beyond(way.y(), edge_y / 2), way.z());
      sum += of_rectangle() * (edge_x * edge_y * way.z() * way.z() / (std::numbers::pi * d * d * d * d));
    }
    return albedo() * sum;
  }

  /// What a pixel shows.
  Rgb<double> pixel(int x, int y, int width, int height, const FilterRule& filter) const {
    const auto floor = [&](double px, double py) { return radiance(point(px, py, width, height)); };
    return of_mirror() * filter.mean(x + 0.5, y + 0.5, floor);
  }
};

}  // namespace fairlight

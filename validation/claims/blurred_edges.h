#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fairlight/render/built_in_scenes.h>
#include <fairlight/validation/claims/filter_rule.h>

namespace fairlight {

/// Four lit rectangles about a point of a plane across the axis of a camera that is focused before
/// or behind it. At u to the right of the axis and v below it the radiance is A + B [u < u0] + C [v
/// < v0], so a pixel shows A + B P(u < u0) + C P(v < v0): its filter and the aperture blur the
/// edges.
/// Formula  the ray through the point l of the lens meets the plane at D s + l (1 - D/f), where s
///          is the direction of the pinhole's ray, D the distance of the plane and f that in focus
/// Source   similar triangles; Cook, Porter, Carpenter 1984
struct BlurredEdges {
  double focus;     ///< f [m]
  double radius;    ///< of the aperture [m], 0 for a pinhole
  int blades;       ///< 0 for a round one
  double rotation;  ///< [rad]

  static constexpr double distance = 3, image_height = 0.2, u0 = 0.0625, v0 = -0.0625;
  static Rgb<double> everywhere() { return {1e-4, 0.5, 1e5}; }
  static Rgb<double> on_the_left() { return {3e-4, 0.25, 1e5}; }
  static Rgb<double> above() { return {1e-4, 1, 2e5}; }

  View view() const {
    const Vec3<double> eye(0.5, 0.25, 2), middle = eye + Vec3<double>(u0, -v0, -distance);
    Scene scene;
    for (const double x : {-8.0, 8.0}) {
      for (const double y : {-8.0, 8.0}) {
        Rgb<double> radiance = everywhere();
        if (x < 0) radiance += on_the_left();
        if (y > 0) radiance += above();
        scene.add_rectangle(middle, {x, 0, 0}, {0, y, 0}, Rgb<double>(0, 0, 0), radiance);
      }
    }
    const Camera camera({.eye = eye,
                         .look = {0, 0, -1},
                         .up = {0, 1, 0},
                         .image_height = image_height,
                         .aperture_radius = radius,
                         .focus_distance = focus,
                         .blades = blades,
                         .blade_rotation = rotation});
    return {"blurred_edges", scene, camera};
  }

  /// The share of the aperture where the coordinate along an axis, 0 to the right or 1 down, is
  /// below t [m].
  double share_below(double t, int axis) const {
    if (blades == 0) {
      const double x = std::clamp(t / radius, -1.0, 1.0);
      return 0.5 + (x * std::sqrt(1 - x * x) + std::asin(x)) / std::numbers::pi;
    }
    // Twice the area of the polygon between each blade, or the part of it below t, and the line at
    // t or the lowest corner. The shoelace formula with the coordinate cut at t: a blade that
    // crosses the line is two segments.
    double below = 0, whole = 0;
    for (int k = 0; k < blades; ++k) {
      const Vec2<double> a = corner(k, axis), b = corner(k + 1, axis);
      whole += a.x() * b.y() - b.x() * a.y();
      const double s = (t - a.x()) / (b.x() - a.x());
      const Vec2<double> m = s > 0 && s < 1 ? Vec2<double>(t, a.y() + s * (b.y() - a.y())) : b;
      below += cut(a, m, t) + cut(m, b, t);
    }
    return below / whole;
  }

  /// P(u < u0) of the pixels of column x, and P(v < v0) of those of row y.
  double left_share(int x, int width, int height, const FilterRule& filter) const {
    return share(u0, x + 0.5 - width / 2.0, height, 0, filter);
  }
  double upper_share(int y, int height, const FilterRule& filter) const {
    return share(v0, y + 0.5 - height / 2.0, height, 1, filter);
  }

 private:
  /// A corner of the polygon: its coordinate along the axis, and the other.
  Vec2<double> corner(int k, int axis) const {
    const double angle = rotation + 2 * std::numbers::pi * k / blades;
    const double right = radius * std::cos(angle), down = radius * std::sin(angle);
    // Mirrored for the second axis, which changes the sign of the area alone.
    return axis == 0 ? Vec2<double>(right, down) : Vec2<double>(down, right);
  }

  /// The shoelace term of a segment with all that is beyond t moved to it.
  static double cut(const Vec2<double>& a, const Vec2<double>& b, double t) {
    return std::min(a.x(), t) * b.y() - std::min(b.x(), t) * a.y();
  }

  /// P(D s + l (1 - D/f) < edge), with s about `middle` pixels from the axis.
  double share(double edge, double middle, int height, int axis, const FilterRule& filter) const {
    const double pixel = distance * image_height / height, blur = radius * (1 - distance / focus);
    if (blur == 0) return filter.share_below(edge / pixel - middle);
    return filter.mean_along([&](double offset) {
      const double t = radius * (edge - (middle + offset) * pixel) / blur;
      return blur > 0 ? share_below(t, axis) : 1 - share_below(t, axis);
    });
  }
};

}  // namespace fairlight

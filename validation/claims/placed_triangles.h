#pragma once

#include <algorithm>

#include <fairlight/estimators/triangle_light.h>
#include <fairlight/validation/claims/lights_at_any_distance.h>

namespace fairlight {

/// A triangle, and a point of a surface that it lights: the corner of a placed rectangle, one side
/// of it, and the other one sheared. From the point, its centroid is at an angle to both normals.
struct PlacedTriangle : PlacedRectangle {
  template <class Real>
  TriangleLight<Real> light() const {
    return {rounded_vector<Real>(corner), rounded_vector<Real>(edge_x), rounded_vector<Real>(edge_y)};
  }
  std::array<Vec3<double>, 3> sides() const {
    const Vec3<double> first = corner - point;
    return {first, first + edge_x, first + edge_y};
  }
  double irradiance() const {
    const auto [a, b, c] = sides();
    return polygon_irradiance(above_horizon({a, b, c}, normal), normal);
  }
  /// Source   van Oosterom and Strackee 1983
  double solid_angle() const {
    const auto [a, b, c] = sides();
    const double x = a.norm(), y = b.norm(), z = c.norm();
    return 2 * std::atan2(std::abs(a.dot(edge_x.cross(edge_y))),
                          x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y);
  }
  /// The largest 1/p by area, A cos_L / t^2, at the least distance; it is no less with the distance
  /// of the plane for t where the foot is inside.
  double area_bound() const {
    const auto [a, b, c] = sides();
    const Vec3<double> across = edge_x.cross(edge_y);
    const double height = std::abs(across.normalized().dot(a)), area = across.norm() / 2;
    const auto distance_of = [](const Vec3<double>& p, const Vec3<double>& q) {
      const Vec3<double> side = q - p;
      return (p + std::clamp(-p.dot(side) / side.squaredNorm(), 0.0, 1.0) * side).norm();
    };
    // The foot is inside if it is on the same side of all edges.
    const auto beside = [&](const Vec3<double>& p, const Vec3<double>& q) { return across.dot(p.cross(q)); };
    const double s = beside(a, b), t = beside(b, c), u = beside(c, a);
    const bool inside = (s > 0) == (t > 0) && (t > 0) == (u > 0);
    const double nearest = inside ? height : std::min({distance_of(a, b), distance_of(b, c), distance_of(c, a)});
    return area * height / (nearest * nearest * nearest);
  }
};

inline double bound_of(const PlacedTriangle& triangle, BoundOfLight by) {
  return by == BoundOfLight::solid_angle ? triangle.solid_angle() : triangle.area_bound();
}

inline void add_triangle_ranges(std::vector<ParameterRange>& ranges, const std::string& light,
                                const RectangleRange& range, bool front) {
  add_rectangle_ranges(ranges, light, range, front);
  ranges.push_back({light, "shear", -1, 1});
}

inline PlacedTriangle placed_triangle(DrawnValues& values) {
  PlacedTriangle placed{placed_rectangle(values)};
  const Vec3<double> centre = placed.corner + (placed.edge_x + placed.edge_y) / 2;
  placed.edge_y += values.next() * placed.edge_x;
  placed.corner = centre - (placed.edge_x + placed.edge_y) / 3;
  return placed;
}

inline std::vector<ParameterRange> three_triangles(const std::string& light,
                                                   const std::array<RectangleRange, 3>& ranges) {
  std::vector<ParameterRange> all;
  for (std::size_t c = 0; c < 3; ++c) add_triangle_ranges(all, light, ranges[c], c != 1);
  return all;
}

inline ThreeLights<PlacedTriangle> placed_triangles(const std::vector<double>& values) {
  DrawnValues next(values);
  ThreeLights<PlacedTriangle> lights;
  for (PlacedTriangle& light : lights) light = placed_triangle(next);
  return lights;
}

/// From 1 nm to 1e9 m. `size` of the middle: larger than the distance, long, small.
inline constexpr std::array<LightRanges<RectangleRange>, 3> triangle_distances{
    {{"near",
      {{{{1e-9, 1e-6}, {0.5, 1.5}, {0.2, 1}},
        {{1e-6, 1e-3}, {0.1, 1.5}, {1e-3, 1}},
        {{1e-3, 0.09}, {0.1, 1.5}, {1e-3, 1}}}}},
     {"middle",
      {{{{0.09, 10}, {0.5, 2}, {0.2, 1}},
        {{0.09, 10}, {0.5, 3}, {1e-3, 1e-2}},
        {{0.09, 10}, {1e-5, 0.1}, {1e-3, 1}}}}},
     {"far",
      {{{{10, 1e3}, {0.1, 1.5}, {1e-3, 1}},
        {{1e3, 1e6}, {0.1, 1.5}, {1e-3, 1}},
        {{1e6, 1e9}, {0.5, 1.5}, {0.2, 1}}}}}}};

/// Triangles that many cosine-weighted directions meet.
inline constexpr std::array<RectangleRange, 3> large_triangles{
    {{{1e-8, 1e-2}, {0.5, 2}, {0.2, 1}}, {{0.09, 10}, {0.5, 3}, {0.2, 1}}, {{1e2, 1e8}, {0.5, 2}, {0.2, 1}}}};

}  // namespace fairlight

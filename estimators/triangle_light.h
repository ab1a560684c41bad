#pragma once

#include <stdexcept>

#include <fairlight/estimators/light_sample.h>
#include <fairlight/estimators/spherical_triangle.h>

namespace fairlight {

/// A triangle that emits from both faces, like all surfaces of a scene. It is not visible from its
/// own plane. `on_surface` marks points on that plane: rounding would put them beside it, where the
/// triangle fills half of all directions.
template <class Real>
class TriangleLight {
  // As for RectangleLight, the support extends beyond the edges by 4 ulp of 1 rad, or by the
  // smallest height of the triangle if that is less.
 public:
  /// A corner and the two edges from it [m], within the range of `longest`. `on_surface`: the
  /// points from which it is seen lie on it. Throws std::invalid_argument outside the range, and
  /// unless the sine of the angle between the edges is at least 1e-4.
  TriangleLight(const Vec3<Real>& corner, const Vec3<Real>& edge_1, const Vec3<Real>& edge_2,
                const Mask<Real>& on_surface = Mask<Real>(false))
      : on_surface_(on_surface), corner_(corner), length_(edge_1.norm()) {
    using std::max;
    const Real second = edge_2.norm();
    require_length(length_, "the length of a triangle's edges");
    require_length(second, "the length of a triangle's edges");
    require_place(corner, "a triangle's corner");
    // By unit vectors, whose products do not overflow.
    x_ = edge_1 / length_;
    const Vec3<Real> along = edge_2 / second, across = x_.cross(along);
    const Real sine = across.norm();
    if (!all(sine >= rounded<Real>(1e-4)))
      throw std::invalid_argument(
          "a triangle's edges must make an angle, of a sine of 1e-4 at least (drop slivers)");
    normal_ = across / sine;
    y_ = normal_.cross(x_);
    foot_ = second * x_.dot(along);
    height_ = second * sine;
    const Real third = Vec2<Real>(foot_ - length_, height_).norm();
    least_height_ = length_ * (height_ / max(Real(max(length_, second)), third));
    second_ = second;
    third_ = third;
  }

  Real area() const { return length_ * height_ / Real(2); }

  /// The vector from a point to the corner, in the triangle's axes [m]: x along the first edge, z
  /// across the plane.
  Vec3<Real> corner_from(const Vec3<Real>& point) const {
    const Vec3<Real> corner = to_axes(corner_ - point);
    return {corner.x(), corner.y(), select(on_surface_, Real(0), corner.z())};
  }
  Vec3<Real> to_axes(const Vec3<Real>& v) const { return {x_.dot(v), y_.dot(v), normal_.dot(v)}; }
  Vec3<Real> from_axes(const Vec3<Real>& v) const { return x_ * v.x() + y_ * v.y() + normal_ * v.z(); }

  /// The edges from the corner, in the triangle's axes [m].
  Vec3<Real> edge_1() const { return {length_, Real(0), Real(0)}; }
  Vec3<Real> edge_2() const { return {foot_, height_, Real(0)}; }

  /// The triangle as a point sees it.
  SphericalTriangle<Real> view(const Vec3<Real>& corner) const {
    using std::abs;
    return {corner, edge_1(), edge_2(), Real(abs(corner.z())), Real(length_ * height_)};
  }

  /// Where a ray from a point hits the triangle: the distance [m], and the cosine there, which is 0
  /// for a miss.
  struct Meeting {
    Real distance;
    Real cosine;
  };
  Meeting meeting(const Vec3<Real>& from, const Vec3<Real>& direction) const {
    using std::abs;
    using std::min;
    const Vec3<Real> corner = corner_from(from);
    const Vec3<Real> w = to_axes(direction);
    const Mask<Real> ahead =
        (corner.z() > Real(0)) == (w.z() > Real(0)) && corner.z() != Real(0) && w.z() != Real(0);
    const Real cosine = abs(w.z());
    const Real inverse = Real(1) / select(ahead, cosine, Real(1));
    const Real distance = abs(corner.z()) * inverse;
    const Real x = distance * w.x() - corner.x();
    const Real y = distance * w.y() - corner.y();
    // The distances from the edges, positive inside.
    const Real left = (height_ * x - foot_ * y) / second_;
    const Real right = (height_ * (length_ - x) + (foot_ - length_) * y) / third_;
    const Real rim = -min(Real(Real(4 * ulp<Real>) * distance * inverse), least_height_);
    return {distance, select(ahead && y >= rim && left >= rim && right >= rim, cosine, Real(0))};
  }

 private:
  Mask<Real> on_surface_;
  Vec3<Real> corner_;
  Real length_, foot_, height_;  ///< the third corner is at (foot, height) in the axes
  Real second_, third_;          ///< the lengths of the other edges
  Real least_height_;
  Vec3<Real> x_, y_, normal_;
};

/// Directions to uniform points of a triangle.
/// Formula  p(w) = t^2 / (A cos_L), t the distance of the point in direction w, cos_L the cosine
///          there
/// Measure  solid angle [1/sr]
/// Domain   directions that hit the triangle, to rounding; none from its own plane, or if the
///          density exceeds `largest_density`; the density is 0 elsewhere
/// Random   u in [0,1)^2
/// Source   Turk 1990, "Generating random points in triangles"
template <class Real>
class TriangleByArea {
 public:
  using Scalar = Real;

  explicit TriangleByArea(const TriangleLight<Real>& triangle) : triangle_(triangle) {}

  LightSample<Real> sample(const Vec3<Real>& from, const Vec2<Real>& u) const {
    using std::abs;
    using std::sqrt;
    const Real root = sqrt(u.x());
    const Vec3<Real> way = triangle_.corner_from(from) + root * (Real(1) - u.y()) * triangle_.edge_1() +
                           root * u.y() * triangle_.edge_2();
    const Real length = way.norm();
    const Real distance = select(length > Real(0), length, Real(1));
    return {triangle_.from_axes(way / distance), length, density(length, Real(abs(way.z()) / distance))};
  }

  Density<SolidAngle, Real> pdf(const Vec3<Real>& from, const Vec3<Real>& direction) const {
    const auto [distance, cosine] = triangle_.meeting(from, direction);
    return density(distance, cosine);
  }

 private:
  Density<SolidAngle, Real> density(Real distance, Real cosine) const {
    const Mask<Real> seen = cosine > Real(0);
    const Density<Area, Real> uniform(Real(1) / triangle_.area());
    const Real over_angle = to_solid_angle(uniform, distance, select(seen, cosine, Real(1))).value();
    return Density<SolidAngle, Real>(
        select(seen && over_angle <= Real(largest_density<Real>), over_angle, Real(0)));
  }

  TriangleLight<Real> triangle_;
};

/// Directions uniform in the solid angle S of a triangle, so distance and cosine add no variance.
/// Formula  p(w) = 1 / S
/// Measure  solid angle [1/sr]
/// Domain   directions that hit the triangle, to rounding; none from its own plane, or if the
///          density exceeds `largest_density`; the density is 0 elsewhere
/// Random   u in [0,1)^2
/// Source   Arvo 1995, "Stratified sampling of spherical triangles"
template <class Real>
class TriangleBySolidAngle {
 public:
  using Scalar = Real;

  explicit TriangleBySolidAngle(const TriangleLight<Real>& triangle) : triangle_(triangle) {}

  LightSample<Real> sample(const Vec3<Real>& from, const Vec2<Real>& u) const {
    const SphericalTriangle<Real> view = triangle_.view(triangle_.corner_from(from));
    const Vec3<Real> way = view.at(u);
    const Real length = way.norm();
    return {triangle_.from_axes(way / length), view.scale() * length, density(view)};
  }

  Density<SolidAngle, Real> pdf(const Vec3<Real>& from, const Vec3<Real>& direction) const {
    const Mask<Real> met = triangle_.meeting(from, direction).cosine > Real(0);
    const SphericalTriangle<Real> view = triangle_.view(triangle_.corner_from(from));
    return Density<SolidAngle, Real>(select(met, density(view).value(), Real(0)));
  }

 private:
  static Density<SolidAngle, Real> density(const SphericalTriangle<Real>& view) {
    const Real all_of_it = view.solid_angle();
    const Mask<Real> seen = view.seen() && all_of_it * Real(largest_density<Real>) >= Real(1);
    return Density<SolidAngle, Real>(select(seen, Real(Real(1) / all_of_it), Real(0)));
  }

  TriangleLight<Real> triangle_;
};

}  // namespace fairlight

#pragma once

#include <stdexcept>

#include <fairlight/estimators/light_sample.h>
#include <fairlight/estimators/ranges.h>
#include <fairlight/estimators/spherical_rectangle.h>

namespace fairlight {

/// A rectangle that emits from both faces, like all surfaces of a scene; for a one-sided light the
/// other radiance is 0. It is not visible from its own plane. `on_surface` marks points on that
/// plane: rounding would put them beside it, where the rectangle fills half of all directions.
template <class Real>
class RectangleLight {
  // In the rectangle's axes a corner is accurate to a few ulp of its distance. If the point is
  // nearer to the plane than that, or the rectangle smaller, the densities are those of a slightly
  // different rectangle. Directions are accurate to a few ulp of 1 rad. Rounding can move one past
  // an edge; it must have a density all the same, so the support extends beyond the edge by 4 ulp
  // of 1 rad, or by the edge's length if that is less.
 public:
  /// A corner and the two edges from it [m], within the range of `longest`. `on_surface`: the
  /// points from which it is seen lie on it. Throws std::invalid_argument outside the range, and
  /// unless the edges are orthogonal to 64 ulp of the product of their lengths.
  RectangleLight(const Vec3<Real>& corner, const Vec3<Real>& edge_x, const Vec3<Real>& edge_y,
                 const Mask<Real>& on_surface = Mask<Real>(false))
      : on_surface_(on_surface), corner_(corner), width_(edge_x.norm()), height_(edge_y.norm()) {
    using std::abs;
    require_length(width_, "the length of a rectangle's edges");
    require_length(height_, "the length of a rectangle's edges");
    require_place(corner, "a rectangle's corner");
    if (!all(abs(edge_x.dot(edge_y)) <= Real(64) * ulp<Real> * width_ * height_))
      throw std::invalid_argument("a rectangle's edges must be orthogonal (other shapes are not sampled)");
    x_ = edge_x / width_;
    y_ = edge_y / height_;
    normal_ = x_.cross(y_);
  }

  Real area() const { return width_ * height_; }
  Real width() const { return width_; }
  Real height() const { return height_; }

  /// The vector from a point to the corner, in the rectangle's axes [m]. z is the signed distance
  /// of the plane.
  Vec3<Real> corner_from(const Vec3<Real>& point) const {
    const Vec3<Real> corner = to_axes(corner_ - point);
    return {corner.x(), corner.y(), select(on_surface_, Real(0), corner.z())};
  }
  Vec3<Real> to_axes(const Vec3<Real>& v) const { return {x_.dot(v), y_.dot(v), normal_.dot(v)}; }
  Vec3<Real> from_axes(const Vec3<Real>& v) const { return x_ * v.x() + y_ * v.y() + normal_ * v.z(); }

  /// Where a ray from a point hits the rectangle: the distance [m], and the cosine there, which is
  /// 0 for a miss.
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
    const Real rim = Real(4 * ulp<Real>) * distance * inverse;
    const Real rim_x = min(rim, width_), rim_y = min(rim, height_);
    const Mask<Real> met = ahead && x >= -rim_x && x <= width_ + rim_x && y >= -rim_y && y <= height_ + rim_y;
    return {distance, select(met, cosine, Real(0))};
  }

 private:
  Mask<Real> on_surface_;
  Vec3<Real> corner_;
  Real width_, height_;
  Vec3<Real> x_, y_, normal_;
};

/// Directions to uniform points of a rectangle.
/// Formula  p(w) = t^2 / (A cos_L), t the distance of the point in direction w, cos_L the cosine
///          there
/// Measure  solid angle [1/sr]
/// Domain   directions that hit the rectangle, to rounding; none from its own plane, or if the
///          density exceeds `largest_density`; the density is 0 elsewhere
/// Random   u in [0,1)^2
/// Source   Shirley, Wang, Zimmerman 1996, 3.3
template <class Real>
class RectangleByArea {
 public:
  using Scalar = Real;

  explicit RectangleByArea(const RectangleLight<Real>& rectangle) : rectangle_(rectangle) {}

  LightSample<Real> sample(const Vec3<Real>& from, const Vec2<Real>& u) const {
    using std::abs;
    const Vec3<Real> way =
        rectangle_.corner_from(from) + Vec3<Real>(rectangle_.width() * u.x(), rectangle_.height() * u.y(), Real(0));
    const Real length = way.norm();
    const Real distance = select(length > Real(0), length, Real(1));
    return {rectangle_.from_axes(way / distance), length, density(length, Real(abs(way.z()) / distance))};
  }

  Density<SolidAngle, Real> pdf(const Vec3<Real>& from, const Vec3<Real>& direction) const {
    const auto [distance, cosine] = rectangle_.meeting(from, direction);
    return density(distance, cosine);
  }

 private:
  Density<SolidAngle, Real> density(Real distance, Real cosine) const {
    const Mask<Real> seen = cosine > Real(0);
    const Density<Area, Real> uniform(Real(1) / rectangle_.area());
    const Real over_angle = to_solid_angle(uniform, distance, select(seen, cosine, Real(1))).value();
    return Density<SolidAngle, Real>(
        select(seen && over_angle <= Real(largest_density<Real>), over_angle, Real(0)));
  }

  RectangleLight<Real> rectangle_;
};

/// Directions uniform in the solid angle S of a rectangle, so distance and cosine add no variance.
/// Formula  p(w) = 1 / S
/// Measure  solid angle [1/sr]
/// Domain   directions that hit the rectangle, to rounding; the density is 0 elsewhere
/// Random   u in [0,1)^2
/// Source   Urena, Fajardo, King 2013, "An area-preserving parametrization for spherical
///          rectangles"
template <class Real>
class RectangleBySolidAngle {
  // There is no such direction from the rectangle's own plane, or if S < 1 / largest_density, or if
  // the plane is nearer than 1e-15 (floats) or 1e-60 (double) times the largest coordinate of a
  // corner.
 public:
  using Scalar = Real;

  explicit RectangleBySolidAngle(const RectangleLight<Real>& rectangle) : rectangle_(rectangle) {}

  LightSample<Real> sample(const Vec3<Real>& from, const Vec2<Real>& u) const {
    const Vec3<Real> corner = rectangle_.corner_from(from);
    const SphericalRectangle<Real> view(corner, rectangle_.width(), rectangle_.height());
    const Vec3<Real> way = view.at(u);
    const Real length = way.norm();
    return {rectangle_.from_axes(way / length), view.scale() * length, density(view)};
  }

  Density<SolidAngle, Real> pdf(const Vec3<Real>& from, const Vec3<Real>& direction) const {
    const Mask<Real> met = rectangle_.meeting(from, direction).cosine > Real(0);
    const SphericalRectangle<Real> view(rectangle_.corner_from(from), rectangle_.width(), rectangle_.height());
    return Density<SolidAngle, Real>(select(met, density(view).value(), Real(0)));
  }

 private:
  static Density<SolidAngle, Real> density(const SphericalRectangle<Real>& view) {
    const Real all_of_it = view.solid_angle();
    const Mask<Real> seen = view.seen() && all_of_it * Real(largest_density<Real>) >= Real(1);
    return Density<SolidAngle, Real>(select(seen, Real(Real(1) / all_of_it), Real(0)));
  }

  RectangleLight<Real> rectangle_;
};

}  // namespace fairlight

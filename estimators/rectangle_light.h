#pragma once

#include <stdexcept>

#include <fairlight/estimators/light_sample.h>
#include <fairlight/estimators/rectangle_view.h>

namespace fairlight {

/// A rectangle that shines from both its faces, as the surfaces of a scene do; where it shines from one alone, the radiance of
/// the other is 0. From its own plane it is not seen, nor from a point on it, which rounding puts beside the plane and which then had half of
/// all directions full of it. In its axes a corner is where it is to some ulp of its distance, in floats as in double: of a rectangle that is nearer to its plane, or smaller, than that, the densities are those of another.
template <class Real>
class RectangleLight {
 public:
  /// A corner and the two edges from it [m]. Throws std::invalid_argument unless the edges are longer than 0 and orthogonal, to
  /// 64 ulp of the product of their lengths. `on_surface` says that the points that it is looked
  /// at from lie on it.
  RectangleLight(const Vec3<Real>& corner, const Vec3<Real>& edge_x, const Vec3<Real>& edge_y,
                 const Mask<Real>& on_surface = Mask<Real>(false))
      : on_surface_(on_surface), corner_(corner), width_(edge_x.norm()), height_(edge_y.norm()) {
    using std::abs;
    if (!all(width_ > Real(0) && height_ > Real(0)))
      throw std::invalid_argument("a rectangle's edges must be longer than 0 (its area divides)");
    if (!all_finite(width_) || !all_finite(height_) || !all_finite(corner))
      throw std::invalid_argument("a rectangle's corner and edges must be finite (points on it are drawn)");
    if (!all(abs(edge_x.dot(edge_y)) <= Real(64) * ulp<Real> * width_ * height_))
      throw std::invalid_argument("a rectangle's edges must be orthogonal (other shapes are not sampled)");
    x_ = edge_x / width_;
    y_ = edge_y / height_;
    normal_ = x_.cross(y_);
  }

  Real area() const { return width_ * height_; }
  Real width() const { return width_; }
  Real height() const { return height_; }

  /// The corner from a point, in the rectangle's own axes [m]: z is the distance of its plane, of either sign.
  Vec3<Real> corner_from(const Vec3<Real>& point) const {
    const Vec3<Real> corner = to_axes(corner_ - point);
    return {corner.x(), corner.y(), select(on_surface_, Real(0), corner.z())};
  }
  Vec3<Real> to_axes(const Vec3<Real>& v) const { return {x_.dot(v), y_.dot(v), normal_.dot(v)}; }
  Vec3<Real> from_axes(const Vec3<Real>& v) const { return x_ * v.x() + y_ * v.y() + normal_ * v.z(); }

  /// Where a ray from a point meets the rectangle: the distance [m], and the cosine there, which is 0 where it does not.
  struct Meeting {
    Real distance;
    Real cosine;
  };
  Meeting meeting(const Vec3<Real>& from, const Vec3<Real>& direction) const {
    using std::abs;
    const Vec3<Real> corner = corner_from(from);
    const Vec3<Real> w = to_axes(direction);
    const Mask<Real> ahead = corner.z() * w.z() > Real(0);
    const Real distance = corner.z() / select(ahead, Real(w.z()), Real(1));
    const Real x = distance * w.x() - corner.x();
    const Real y = distance * w.y() - corner.y();
    const Mask<Real> met = ahead && x >= Real(0) && x <= width_ && y >= Real(0) && y <= height_;
    return {distance, select(met, Real(abs(w.z())), Real(0))};
  }

 private:
  Mask<Real> on_surface_;
  Vec3<Real> corner_;
  Real width_, height_;
  Vec3<Real> x_, y_, normal_;
};

/// Directions to uniform points of a rectangle.
/// Formula  p(w) = t^2 / (A cos_L), t the distance of the point in the direction w, cos_L the cosine there
/// Measure  solid angle [1/sr]
/// Domain   directions that meet the rectangle; none from its own plane; the density is 0 elsewhere
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
    const auto over_angle = to_solid_angle(uniform, distance, select(seen, cosine, Real(1)));
    return Density<SolidAngle, Real>(select(seen, over_angle.value(), Real(0)));
  }

  RectangleLight<Real> rectangle_;
};

/// Directions uniform in the solid angle S that a rectangle fills: its nearness and its cosine make no variance.
/// Formula  p(w) = 1 / S
/// Measure  solid angle [1/sr]
/// Domain   directions that meet the rectangle, to rounding; none from its own plane; the density is 0 elsewhere
/// Random   u in [0,1)^2
/// Source   Urena, Fajardo, King 2013, "An area-preserving parametrization for spherical rectangles"
template <class Real>
class RectangleBySolidAngle {
 public:
  using Scalar = Real;

  explicit RectangleBySolidAngle(const RectangleLight<Real>& rectangle) : rectangle_(rectangle) {}

  LightSample<Real> sample(const Vec3<Real>& from, const Vec2<Real>& u) const {
    using std::abs;
    const Vec3<Real> corner = rectangle_.corner_from(from);
    const Mask<Real> seen = abs(corner.z()) > Real(0);
    const RectangleView<Real> view = seen_at_unit_height(corner);
    const Vec2<Real> point = view.at(u);
    const Vec3<Real> way(point.x(), point.y(), select(corner.z() > Real(0), Real(1), Real(-1)));
    const Real length = way.norm();
    return {rectangle_.from_axes(way / length), abs(corner.z()) * length,
            Density<SolidAngle, Real>(select(seen, Real(Real(1) / view.solid_angle()), Real(0)))};
  }

  Density<SolidAngle, Real> pdf(const Vec3<Real>& from, const Vec3<Real>& direction) const {
    const Mask<Real> met = rectangle_.meeting(from, direction).cosine > Real(0);
    const Real solid_angle = seen_at_unit_height(rectangle_.corner_from(from)).solid_angle();
    return Density<SolidAngle, Real>(select(met, Real(Real(1) / solid_angle), Real(0)));
  }

 private:
  // In its own plane, where it is not seen, as if from 1 m above it. The far edges are found before anything is divided: where
  // they are near, the sum of a corner and a long edge is exact.
  RectangleView<Real> seen_at_unit_height(const Vec3<Real>& corner) const {
    using std::abs;
    const Real plane = abs(corner.z());
    const Real unit = select(plane > Real(0), plane, Real(1));
    const Real width = rectangle_.width(), height = rectangle_.height();
    const Real far_x = corner.x() + width, far_y = corner.y() + height;
    return {corner.x() / unit, far_x / unit, corner.y() / unit, far_y / unit, width / unit, height / unit};
  }

  RectangleLight<Real> rectangle_;
};

}  // namespace fairlight

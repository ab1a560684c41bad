#pragma once

#include <stdexcept>

#include <fairlight/estimators/cone.h>
#include <fairlight/estimators/light_sample.h>
#include <fairlight/estimators/ranges.h>

namespace fairlight {

/// A sphere as seen from a point, in a frame whose +z leads from the point to the centre. With
/// radius r and distance d of the centre, all formulas use the height h = d - r above the surface.
/// So nothing cancels for a point near a large sphere or far from a small one.
template <class Real>
class SphereFromPoint {
  // A point outside (h > 0) sees the outer face; a point inside (h < 0) sees the inner face. A
  // point on the surface (h = 0) also sees the inner face, in the half of all directions that lead
  // inwards. A branch that a select drops may be NaN. The height is accurate to a few ulp of d, as
  // the point itself is. Closer to the surface than that (in floats some cm for a sphere of 1e5 m),
  // the sphere appears as from a point displaced by that error, maybe to the other side.
  // `on_surface` decides such cases. A direction is accurate to a few ulp of 1 rad. Rounding can
  // move one past the rim; it must have a density all the same, or the weights of multiple
  // importance sampling would not sum to 1. So the support extends `rim` beyond the edge, however
  // small the sphere.
 public:
  /// The smallest r / d: 1e-16 in floats, less its rounding. The largest density is that of the
  /// visible hemisphere, 1 / (2 pi (r/d)^2 cos), at the smallest cosine of a float, 2^-24. It
  /// overflows below 9e-17.
  static constexpr Lane<Real> smallest = in_floats<Real> ? Lane<Real>(9e-17) : Lane<Real>(1e-120);

  /// How far a direction may be past the rim [rad]. Half an ulp each for the rounding of the
  /// direction, of the offset and of the axis; half for the residue across the axis; and the same
  /// again for a ray tracer's own rounding.
  static constexpr Lane<Real> rim = 4 * ulp<Real>;

  /// `offset` is the point minus the centre [m]. Throws std::invalid_argument if r / d is below
  /// `smallest`.
  SphereFromPoint(const Vec3<Real>& offset, Real radius, const Mask<Real>& on_surface)
      : offset_(offset),
        frame_(ahead(offset)),
        radius_(radius),
        distance_(select(on_surface, radius, Real(offset.norm()))),
        height_(distance_ - radius) {
    if (!all(Real(smallest) * distance_ <= radius)) {
      detail::refuse<Real>("a sphere is smaller than 1e-16 of its distance in floats, or 1e-120 in double",
                           " (make it larger, or a point)");
    }
  }

  Mask<Real> outside() const { return height_ > Real(0); }

  /// The light sample towards a point of the sphere, which was drawn with the given density.
  /// `normal` is the outward normal there, in the frame except that its z is positive on the half
  /// that faces the point: (0, 0, 1) is the nearest point.
  LightSample<Real> towards(const Vec3<Real>& normal, Density<Area, Real> density) const {
    const Real drop = detail::drop_below_pole(normal);
    const Vec3<Real> way(radius_ * normal.x(), radius_ * normal.y(), height_ + radius_ * drop);
    const Real length = way.norm();
    const Real distance = select(length > Real(0), length, Real(1));
    const Real inverse = Real(1) / distance;
    const Real inwards = (distance_ * drop - height_) * inverse;
    const Real cosine = select(outside(), Real(-inwards), inwards);
    const Mask<Real> seen = cosine > Real(0);
    const auto over_angle = to_solid_angle(density, distance, select(seen, cosine, Real(1)));
    return {frame_.to_world(Vec3<Real>(way * inverse)), length,
            Density<SolidAngle, Real>(select(seen, over_angle.value(), Real(0)))};
  }

  /// The light sample in a direction of the cone, with 1 - cos(theta) = u_x (1 - cos(a)). Half of
  /// the chord is r sqrt((1 - u_x) (cos(theta) + cos(a)) / (1 + cos(a))) outside, and sqrt(d^2
  /// cos^2(theta) - level) inside.
  LightSample<Real> within_cone(const Vec2<Real>& u) const {
    using std::sqrt;
    const Real edge = cap();
    const Real drop = u.x() * edge;
    const Real along = distance_ * (Real(1) - drop);
    const Real rest = Real(2) - edge;
    const Real half_chord = select(outside(), Real(radius_ * sqrt((Real(1) - u.x()) * (rest - drop) / rest)),
                                   Real(sqrt(inner_square(along))));
    const UniformCone<Real> directions(edge);
    return {frame_.to_world(directions.sample(u)), distance(along, half_chord),
            Density<SolidAngle, Real>(Real(1) / directions.solid_angle())};
  }

  /// The density of a direction whose point on the sphere has the given density, which is constant
  /// on the visible part; 0 if the direction misses.
  // The point of the line that is nearest to the centre decides whether the direction hits.
  // Rounding along the line changes its distance only to second order, while the axes of a frame
  // would each add an error. A direction past the rim, within rounding, gets the density of one as
  // far inside, since rounding moves equally many either way.
  Density<SolidAngle, Real> over_angle(const Vec3<Real>& direction, Density<Area, Real> density) const {
    using std::abs;
    using std::sqrt;
    const Real along = -offset_.dot(direction);
    const Real nearest = Vec3<Real>(offset_ + along * direction).squaredNorm();
    const Real square = select(outside(), Real(abs(radius_ * radius_ - nearest)), inner_square(along));
    const Real reach = radius_ + rim * distance_;
    const Mask<Real> near = nearest <= reach * reach || !outside();
    const Mask<Real> met = near && square > Real(0) && (along > Real(0) || height_ < Real(0));
    const Real half_chord = sqrt(select(met, square, radius_ * radius_));
    const auto over_angle = to_solid_angle(density, distance(along, half_chord), Real(half_chord / radius_));
    return Density<SolidAngle, Real>(select(met, over_angle.value(), Real(0)));
  }

  /// The density of a direction drawn by within_cone; inside the sphere, of any direction. For the
  /// angle theta from the axis, the squared chord of the unit sphere is 2 (1 - cos(theta)) = 2
  /// sin^2(theta) / (1 + cos(theta)). Its own rounding error is 8 ulp of it.
  Density<SolidAngle, Real> cone_density(const Vec3<Real>& direction) const {
    using std::sqrt;
    const Vec3<Real> axis = ahead(offset_);
    const Real cosine = axis.dot(direction);
    const Real sine_squared = Vec3<Real>(direction - cosine * axis).squaredNorm();
    const Real height = cap();
    const Real chord = sqrt(Real(2) * height) * Real(1 + 8 * ulp<Real>) + Real(rim);
    const Mask<Real> near = Real(2) * sine_squared <= chord * chord * (Real(1) + cosine) && cosine > Real(-rim);
    const Mask<Real> meets = near || height_ < Real(0);
    return Density<SolidAngle, Real>(select(meets, Real(Real(1) / (Real(2) * pi<Real> * height)), Real(0)));
  }

 private:
  // The unit vector from the point to the centre; an arbitrary one if they coincide.
  static Vec3<Real> ahead(const Vec3<Real>& offset) {
    const Real length = offset.norm();
    const Mask<Real> apart = length > Real(0);
    const Real inverse = Real(-1) / select(apart, length, Real(1));
    return select(apart, Vec3<Real>(offset * inverse), Vec3<Real>(Real(0), Real(0), Real(1)));
  }

  // 1 - cos(a) of the cone of directions that hit the sphere. Outside, sin(a) = r/d. On the surface
  // a is 90 degrees; inside it is 180 degrees, as all directions hit.
  Real cap() const {
    using std::sqrt;
    const Real ratio = radius_ / distance_;
    const Real cosine = sqrt(select(outside(), level(), Real(0))) / distance_;
    return select(height_ < Real(0), Real(2), Real(ratio * ratio / (Real(1) + cosine)));
  }

  // d^2 - r^2 [m^2], the product of the distances to the two hits of any line through the point.
  Real level() const { return height_ * (distance_ + radius_); }

  // The square of half the chord, for a point that is not outside.
  Real inner_square(Real along) const { return along * along - level(); }

  // The distance to the nearer hit outside, to the only hit ahead inside; each in the form that
  // does not cancel.
  Real distance(Real along, Real half_chord) const {
    using std::abs;
    const Real sum = abs(along) + half_chord;
    const Mask<Real> far = !outside() && along > Real(0);
    return select(far, sum, Real(abs(level()) / select(sum > Real(0), sum, Real(1))));
  }

  Vec3<Real> offset_;
  Frame<Real> frame_;
  Real radius_, distance_, height_;
};

/// A sphere that emits from both faces.
template <class Real>
class SphereLight {
 public:
  /// Centre and radius [m], within the range of `longest`; throws std::invalid_argument otherwise.
  /// `on_surface`: the lit points are on the sphere itself, where rounding would put them on either
  /// side of it.
  SphereLight(const Vec3<Real>& centre, Real radius, const Mask<Real>& on_surface = Mask<Real>(false))
      : centre_(centre), radius_(radius), on_surface_(on_surface) {
    require_length(radius, "a sphere's radius");
    require_place(centre, "a sphere's centre");
  }

  Real radius() const { return radius_; }
  SphereFromPoint<Real> seen_from(const Vec3<Real>& point) const { return {point - centre_, radius_, on_surface_}; }

 private:
  Vec3<Real> centre_;
  Real radius_;
  Mask<Real> on_surface_;
};

}  // namespace fairlight

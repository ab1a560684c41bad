#pragma once

#include <stdexcept>

#include <fairlight/estimators/cone.h>
#include <fairlight/estimators/light_sample.h>
#include <fairlight/estimators/ranges.h>

namespace fairlight {

/// A sphere from where a point stands, in a frame whose +z leads from the point to the centre. With r the radius and d the
/// distance of the centre, everything comes from the height h = d - r above the surface, so that nothing cancels for a point
/// that is near a large sphere or far from a small one.
/// Outside (h > 0) the outer face is seen, inside (h < 0) the inner one; at the surface (h = 0) the inner one too,
/// through the half of all directions that lead inwards. Where a select drops a branch, that may be a NaN.
/// The height, as the point itself, is known to some ulp of d. From nearer to the surface than that, in floats some cm from a
/// sphere of 1e5 m, the sphere is seen as from a point as far off, maybe on its other side, unless `on_surface` decides.
/// A direction is known to some ulp of 1 rad. One that rounding takes past the rim has a density all the same, else the
/// weights of multiple importance sampling did not sum to one: the support ends `rim` beyond it, however small the sphere.
template <class Real>
class SphereView {
 public:
  /// The smallest r / d: 1e-16 in floats, but for rounding. The density of the visible hemisphere, 1 / (2 pi (r/d)^2 cos),
  /// is the largest, at a cosine of 2^-24 that floats still tell from 0; below 9e-17 it is no number.
  static constexpr Lane<Real> smallest = in_floats<Real> ? Lane<Real>(9e-17) : Lane<Real>(1e-120);

  /// By how much a direction may be past the rim [rad]. Half an ulp each for a direction that is rounded, for the offset
  /// and for the axis, half for what is left across the axis, and as much again for what a ray tracer adds.
  static constexpr Lane<Real> rim = 4 * ulp<Real>;

  /// The offset leads from the centre to the point [m]. Throws std::invalid_argument where r / d is below `smallest`.
  SphereView(const Vec3<Real>& offset, Real radius, const Mask<Real>& on_surface)
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

  /// The sample in the direction of a point of the sphere, drawn with the given density. `normal` is its outward normal, in
  /// the frame but for its z, which is positive on the half that faces the point: (0, 0, 1) is that of the nearest.
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

  /// The sample in a direction of the cone, at 1 - cos(theta) = u_x (1 - cos(a)) from its axis. Half of the chord is
  /// r sqrt((1 - u_x) (cos(theta) + cos(a)) / (1 + cos(a))) outside, and sqrt(d^2 cos^2(theta) - level) inside.
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

  /// The density of a direction whose point on the sphere is drawn with the given one, which is constant on what is seen;
  /// 0 where the direction does not meet it. Whether it does, the point of its line that is nearest to the centre says: what rounding
  /// takes it along the line changes its distance but to second order, where a frame's axes would each add theirs. Past the
  /// rim, to rounding, the density is that of a direction as far within, since rounding takes as many either way.
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

  /// The density of a direction drawn by within_cone; inside the sphere that is every direction. At the angle theta from the
  /// axis, the square of the chord is 2 (1 - cos(theta)) = 2 sin^2(theta) / (1 + cos(theta)); its own rounding is 8 ulp of it.
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
  // From the point to the centre; any direction where they are one.
  static Vec3<Real> ahead(const Vec3<Real>& offset) {
    const Real length = offset.norm();
    const Mask<Real> apart = length > Real(0);
    const Real inverse = Real(-1) / select(apart, length, Real(1));
    return select(apart, Vec3<Real>(offset * inverse), Vec3<Real>(Real(0), Real(0), Real(1)));
  }

  // 1 - cos(a) of the cone of directions that meet the sphere: outside sin(a) = r/d; at the surface a is a right angle, and
  // inside, where all directions do, two.
  Real cap() const {
    using std::sqrt;
    const Real ratio = radius_ / distance_;
    const Real cosine = sqrt(select(outside(), level(), Real(0))) / distance_;
    return select(height_ < Real(0), Real(2), Real(ratio * ratio / (Real(1) + cosine)));
  }

  // d^2 - r^2 [m^2], the product of the distances at which any line through the point meets the sphere.
  Real level() const { return height_ * (distance_ + radius_); }

  // The square of half the chord, for a point that is not outside.
  Real inner_square(Real along) const { return along * along - level(); }

  // To the nearer meeting outside, to the only one ahead inside; each from the form that does not cancel.
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

/// A sphere that shines from both its faces.
template <class Real>
class SphereLight {
 public:
  /// Centre and radius [m], within the range of `longest`; throws std::invalid_argument otherwise. `on_surface` says that
  /// the points that it lights are on the sphere itself, which rounding would put to either side of it.
  SphereLight(const Vec3<Real>& centre, Real radius, const Mask<Real>& on_surface = Mask<Real>(false))
      : centre_(centre), radius_(radius), on_surface_(on_surface) {
    require_length(radius, "a sphere's radius");
    require_place(centre, "a sphere's centre");
  }

  Real radius() const { return radius_; }
  SphereView<Real> seen_from(const Vec3<Real>& point) const { return {point - centre_, radius_, on_surface_}; }

 private:
  Vec3<Real> centre_;
  Real radius_;
  Mask<Real> on_surface_;
};

}  // namespace fairlight

#pragma once

#include <algorithm>

#include <fairlight/estimators/ranges.h>

namespace fairlight {

/// The map from the unit square to a rectangle [x0, x1] x [y0, y1] in the plane at distance z from
/// the origin, uniform in solid angle. As in Urena, Fajardo and King 2013, u_x chooses x by the
/// solid angle on either side of it, and u_y chooses y by the sines of the angles above and below
/// it. Unlike there, no step subtracts large, almost equal angles, so the rectangle may be small,
/// far away or seen at a grazing angle.
template <class Real>
class SphericalRectangle {
  // Let K(x) be the solid angle of [0, x] x [y0, y1], b_i = atan(y_i / z) and sin(A_i) = sin(b_i) x
  // / sqrt(z^2 + x^2). Then K = A_1 - A_0 (Urena et al., eq. 5, rewritten). Let s be half the solid
  // angle of the strip between y0 and y1 beyond x: K = (b_1 - b_0) - 2 s. Solving for x,
  //   x = z (w cos 2s - m sin 2s) /
  //       (2 sqrt(sin s (w cos s - m sin s) (z cos s + y1 sin s) (z cos s - y0 sin s)))
  // with w = z (y1 - y0) and m = z^2 + y0 y1. For s <= (b_1 - b_0) / 2, that is x >= 0, nothing
  // cancels under the root; otherwise the strip is measured from its other end. All lengths are
  // divided by the largest coordinate, and no product has more than two of them before a division
  // or a root. So nothing overflows, and underflow loses at most a fraction of 1e-36 of the whole.
 public:
  /// `corner` is the corner of smallest x and y in the rectangle's axes [m], with z of either sign.
  /// The far corner is computed before any division: if it is near the origin, the sum of a
  /// coordinate and a long edge is exact.
  SphericalRectangle(const Vec3<Real>& corner, Real width, Real height)
      : scale_(largest(corner, width, height)),
        x0_(corner.x() / scale_),
        x1_(Real(corner.x() + width) / scale_),
        y0_(corner.y() / scale_),
        y1_(Real(corner.y() + height) / scale_),
        width_(width / scale_),
        height_(height / scale_) {
    using std::abs;
    const Real plane = abs(corner.z()) / scale_;
    seen_ = plane >= Real(nearest);
    z_ = select(seen_, plane, Real(1));
    side_ = select(corner.z() > Real(0), z_, Real(-z_));
    half_angle_ = half_solid_angle();
  }

  /// Whether the plane is at least `nearest` times `scale` from the origin. If not, its distance is
  /// taken to be `scale`.
  Mask<Real> seen() const { return seen_; }

  /// [sr]
  Real solid_angle() const { return Real(2) * half_angle_; }

  /// The unit of length of `at` [m].
  Real scale() const { return scale_; }

  /// The image of a point of the unit square, in units of `scale`.
  Vec3<Real> at(const Vec2<Real>& u) const {
    const Real x = across(u.x());
    return {x, along(x, u.y()), side_};
  }

 private:
  static constexpr Lane<Real> nearest = in_floats<Real> ? Lane<Real>(1e-15) : Lane<Real>(1e-60);

  static Real largest(const Vec3<Real>& corner, Real width, Real height) {
    using std::abs;
    using std::max;
    const Real x = max(Real(abs(corner.x())), Real(abs(Real(corner.x() + width))));
    const Real y = max(Real(abs(corner.y())), Real(abs(Real(corner.y() + height))));
    return max(Real(max(x, y)), Real(abs(corner.z())));
  }

  Real half_solid_angle() const {
    using std::abs;
    const Real first = abs(x0_), second = abs(x1_);
    const Mask<Real> straddles = x0_ < Real(0) && x1_ > Real(0);
    const Real near = select(first < second, first, second);
    const Real far = select(first < second, second, first);
    const Real one_side = half_between(near, far, width_);
    const Real both_sides = half_between(Real(0), near, near) + half_between(Real(0), far, far);
    return select(straddles, both_sides, one_side);
  }

  // The distances of (x, y0) and (x, y1) from the origin, and the squared distance q of (x, 0).
  struct Ends {
    Real q, first, second;
  };
  Ends ends(Real x) const {
    using std::sqrt;
    const Real q = z_ * z_ + x * x;
    return {q, sqrt(q + y0_ * y0_), sqrt(q + y1_ * y1_)};
  }

  // r_a r_b + a b without cancellation. It is positive; r_a^2 = q + a^2, r_b^2 = q + b^2.
  static Real root_plus_product(Real q, Real a, Real b, Real root) {
    using std::abs;
    const Real quotient = q * Real(Real(q + a * a + b * b) / Real(root + abs(a * b)));
    return select(a * b < Real(0), quotient, Real(root + a * b));
  }

  // For the region [x, inf) x [y0, y1], x >= 0, which is a triangle with one corner at infinity:
  // tan(S / 2) = z (y1 - y0) / below, with below = (x + r0)(x + r1) + z^2 + y0 y1 and r_i^2 = z^2 +
  // x^2 + y_i^2. Source: van Oosterom and Strackee 1983.
  struct Beyond {
    Real first, second;  // r0, r1
    Real below;
  };
  Beyond beyond(Real x) const {
    const auto [q, r0, r1] = ends(x);
    return {r0, r1, x * (r0 + r1) + q + root_plus_product(q, y0_, y1_, Real(r0 * r1))};
  }

  // Half the solid angle of [x, inf) x [y0, y1]. `quarter` is that of [0, inf) x [y0, y1].
  Real half_beyond(Real x, Real quarter) const {
    using std::abs;
    using std::atan;
    const Real half = atan(Real(z_ * height_ / beyond(Real(abs(x))).below));
    return select(x < Real(0), Real(Real(2) * quarter - half), half);
  }

  // Half the solid angle of [near, far] x [y0, y1], near >= 0: that beyond `near` minus that beyond
  // `far`, by the tangent of the difference. There far.below - near.below has the factor far -
  // near.
  Real half_between(Real near, Real far, Real apart) const {
    using std::atan;
    const Beyond a = beyond(near), b = beyond(far);
    const Real first = near + a.first + far + b.first;
    const Real second = near + a.second + far + b.second;
    const Real more =
        first / (a.first + b.first) * (far + b.second) + (near + a.first) * second / (a.second + b.second);
    const Real tangent = z_ * height_ / a.below;  // of half the solid angle beyond `near`
    return atan(Real(tangent * Real(apart * more) / (b.below + tangent * (z_ * height_))));
  }

  Real across(Real u) const {
    using std::atan;
    using std::cos;
    using std::sin;
    using std::sqrt;
    const Real w = z_ * height_, m = z_ * z_ + y0_ * y1_;
    const Real quarter = atan(Real(w / beyond(Real(0)).below));
    const Real above = half_beyond(x1_, quarter) + (Real(1) - u) * half_angle_;
    const Real below = half_beyond(Real(-x0_), quarter) + u * half_angle_;
    const Real s = select(above < below, above, below);
    const Real a = sin(s), c = cos(s);
    const Real numerator = w * (c - a) * (c + a) - Real(2) * m * a * c;
    const Real by_strip = Real(2) * sqrt(a) * sqrt(Real(w * c - m * a));
    const Real by_ends = sqrt(Real((z_ * c + y1_ * a) * (z_ * c - y0_ * a)));
    const Real x = numerator / by_strip * Real(z_ / by_ends);
    return select(above < below, x, Real(-x));
  }

  // 1 - y / r, with r = sqrt(q + y^2).
  static Real sine_short_of_one(Real q, Real y, Real r) {
    using std::abs;
    return select(y > Real(0), Real(q / (r * (r + abs(y)))), Real(Real(1) + abs(y) / r));
  }

  Real along(Real x, Real v) const {
    using std::sqrt;
    const auto [q, r0, r1] = ends(x);
    const Real root = r0 * r1;
    const Real span =
        Real(height_ / (r0 + r1)) * Real(Real(q + root_plus_product(q, y0_, Real(-y1_), root)) / root);
    const Real above = sine_short_of_one(q, y1_, r1) + (Real(1) - v) * span;
    const Real below = sine_short_of_one(q, Real(-y0_), r0) + v * span;
    return sqrt(q) * (below - above) / (Real(2) * sqrt(below * above));
  }

  Real scale_;  ///< [m]
  Real x0_, x1_, y0_, y1_, width_, height_;
  Mask<Real> seen_;
  Real z_, side_;    ///< distance of the plane: unsigned, signed
  Real half_angle_;  ///< half of the solid angle [sr]
};

}  // namespace fairlight

#pragma once

#include <array>

#include <fairlight/estimators/vec.h>

namespace fairlight {

/// A rectangle [x0, x1] x [y0, y1] in the plane z = 1, as the origin sees it: the map from the unit square to it that is uniform
/// in solid angle. As in Urena, Fajardo and King 2013 the first number chooses x, by the solid angle on either side of
/// it, and the second y, by the sines of the angles above and below it. Unlike there, no step takes a small
/// difference of large angles, so a rectangle may be small, far off or grazed.
///
/// With K(x) the solid angle of [0, x] x [y0, y1] and b_i = atan(y_i), sin(A_i) = sin(b_i) x / sqrt(1 + x^2),
/// K = A_1 - A_0 (Urena et al., eq. 5, rewritten). Let s be half the solid angle of what is beyond x in the strip
/// between y0 and y1, K = (b_1 - b_0) - 2 s. Solving for x,
///   x = (w cos 2s - m sin 2s) / (2 sqrt(sin s (w cos s - m sin s) (cos s + y1 sin s) (cos s - y0 sin s)))
/// with w = y1 - y0 and m = 1 + y0 y1, which for s <= (b_1 - b_0) / 2, that is x >= 0, has no small difference under its root;
/// else the strip is looked at from its other end.
template <class Real>
class RectangleView {
 public:
  RectangleView(Real x0, Real x1, Real y0, Real y1, Real width, Real height)
      : x0_(x0), x1_(x1), y0_(y0), y1_(y1), width_(width), height_(height), half_angle_(half_solid_angle()) {}

  /// [sr]
  Real solid_angle() const { return Real(2) * half_angle_; }

  /// The point (x, y) of a point of the unit square.
  Vec2<Real> at(const Vec2<Real>& u) const {
    const Real x = across(u.x());
    return {x, along(x, u.y())};
  }

 private:
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

  // sqrt((q + a^2)(q + b^2)) + a b, which is positive, without cancellation.
  static Real root_plus_product(Real q, Real a, Real b) {
    using std::abs;
    using std::sqrt;
    const Real root = sqrt((q + a * a) * (q + b * b));
    const Real quotient = q * (q + a * a + b * b) / (root + abs(a * b));
    return select(a * b < Real(0), quotient, Real(root + a * b));
  }

  // Of the triangle [x, inf) x [y0, y1], x >= 0, with one corner at infinity: tan(S / 2) = (y1 - y0) / below, with
  // below = (x + r0)(x + r1) + 1 + y0 y1, r_i^2 = 1 + x^2 + y_i^2. Source: van Oosterom and Strackee 1983.
  struct Beyond {
    Real first, second;  // r0, r1
    Real below;
  };
  Beyond beyond(Real x) const {
    using std::sqrt;
    const Real q = Real(1) + x * x;
    const Real r0 = sqrt(q + y0_ * y0_), r1 = sqrt(q + y1_ * y1_);
    return {r0, r1, x * (r0 + r1) + q + root_plus_product(q, y0_, y1_)};
  }

  // Half the solid angle of [x, inf) x [y0, y1], and `quarter` that of [0, inf).
  Real half_beyond(Real x, Real quarter) const {
    using std::abs;
    using std::atan;
    const Real half = atan(Real(height_ / beyond(Real(abs(x))).below));
    return select(x < Real(0), Real(Real(2) * quarter - half), half);
  }

  // Half the solid angle of [near, far] x [y0, y1] at x >= 0: that beyond near but not beyond far, by the tangent of the
  // difference, in which far below - near below has the factor far - near.
  Real half_between(Real near, Real far, Real apart) const {
    using std::atan;
    const Beyond a = beyond(near), b = beyond(far);
    const Real first = near + a.first + far + b.first;
    const Real second = near + a.second + far + b.second;
    const Real more =
        first / (a.first + b.first) * (far + b.second) + (near + a.first) * second / (a.second + b.second);
    return atan(Real(height_ * apart * more / (a.below * b.below + height_ * height_)));
  }

  Real across(Real u) const {
    using std::atan;
    using std::cos;
    using std::sin;
    using std::sqrt;
    const Real quarter = atan(Real(height_ / beyond(Real(0)).below));
    const Real above = half_beyond(x1_, quarter) + (Real(1) - u) * half_angle_;
    const Real below = half_beyond(Real(-x0_), quarter) + u * half_angle_;
    const Real s = select(above < below, above, below);
    const Real a = sin(s), c = cos(s), m = Real(1) + y0_ * y1_;
    const Real numerator = height_ * (c - a) * (c + a) - Real(2) * m * a * c;
    const Real x = numerator / (Real(2) * sqrt(a * (height_ * c - m * a) * (c + y1_ * a) * (c - y0_ * a)));
    return select(above < below, x, Real(-x));
  }

  // 1 - y / sqrt(q + y^2)
  static Real sine_short_of_one(Real q, Real y) {
    using std::abs;
    using std::sqrt;
    const Real r = sqrt(q + y * y);
    return select(y > Real(0), Real(q / (r * (r + abs(y)))), Real(Real(1) + abs(y) / r));
  }

  Real along(Real x, Real v) const {
    using std::sqrt;
    const Real q = Real(1) + x * x;
    const Real r0 = sqrt(q + y0_ * y0_), r1 = sqrt(q + y1_ * y1_);
    const Real span = height_ * (q + root_plus_product(q, y0_, Real(-y1_))) / ((r0 + r1) * r0 * r1);
    const Real above = sine_short_of_one(q, y1_) + (Real(1) - v) * span;
    const Real below = sine_short_of_one(q, Real(-y0_)) + v * span;
    return sqrt(q) * (below - above) / (Real(2) * sqrt(below * above));
  }

  Real x0_, x1_, y0_, y1_, width_, height_;
  Real half_angle_;  ///< half of the solid angle [sr]
};

}  // namespace fairlight

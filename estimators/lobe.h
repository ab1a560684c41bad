#pragma once

#include <stdexcept>

#include <fairlight/estimators/density.h>
#include <fairlight/estimators/polar.h>

namespace fairlight {

/// The Phong lobe: directions in proportion to a power of the cosine of the angle alpha to an axis.
/// Formula  p(w) = (n + 1) / (2 pi) cos^n(alpha)
/// Measure  solid angle [1/sr]
/// Domain   unit vectors with alpha < 90 degrees; the density is 0 elsewhere
/// Random   u in [0,1)^2
/// Source   Lafortune and Willems 1994, "Using the modified Phong reflectance model for physically
///          based rendering"
template <class Real>
class PowerCosineLobe {
  // The surface may cut off a part of the lobe. For n < 1 rounding can move a draw to 90 degrees or
  // beyond, where it has density 0. Computes with 1 - cos(alpha), which suits any exponent: in
  // floats, cos(alpha)^(10^6) turns the rounding of the cosine into an error of 6 %.
 public:
  using Scalar = Real;
  using Point = Vec3<Real>;
  using Measure = SolidAngle;

  /// Axis: a unit vector; exponent n in [0, 1e8]. Throws std::invalid_argument otherwise. Floats
  /// cannot resolve sharper lobes.
  PowerCosineLobe(const Vec3<Real>& axis, Real exponent) : axis_(axis), frame_(axis), exponent_(exponent) {
    if (!all_within(exponent, 0, 1e8)) {
      throw std::invalid_argument("a lobe's exponent must be nonnegative and finite, at most 1e8 (take a mirror)");
    }
    require_unit(axis, "a lobe's axis");
  }

  /// cos(alpha)^(n + 1) = 1 - u_x.
  Point sample(const Vec2<Real>& u) const {
    using std::expm1;
    using std::log1p;
    const Real drop = -expm1(Real(log1p(-u.x()) / (exponent_ + Real(1))));
    return frame_.to_world(detail::direction_below_pole(drop, u.y()));
  }

  /// The azimuth is that of w - axis, whose small components are exact; those of w cancel.
  Vec2<Real> invert(const Point& w) const {
    using std::expm1;
    const Real u = -expm1(Real((exponent_ + Real(1)) * log_cosine(drop(w))));
    return {u, detail::turn_about_z(frame_.to_local(w - axis_))};
  }

  Density<Measure, Real> pdf(const Point& w) const {
    using std::exp;
    const Real below = drop(w);
    const Real height = (exponent_ + Real(1)) / (Real(2) * pi<Real>);
    return Density<Measure, Real>(
        select(below < Real(1), Real(height * exp(Real(exponent_ * log_cosine(below)))), Real(0)));
  }

 private:
  /// 1 - cos(alpha) = |w - axis|^2 / 2, for unit vectors.
  Real drop(const Point& w) const { return Vec3<Real>(w - axis_).squaredNorm() / Real(2); }

  /// log(cos(alpha)) inside the lobe. Outside it has no value, and the result is an unused 0.
  static Real log_cosine(Real drop) {
    using std::log1p;
    return log1p(-select(drop < Real(1), drop, Real(0)));
  }

  Vec3<Real> axis_;
  Frame<Real> frame_;
  Real exponent_;
};

}  // namespace fairlight

#pragma once

#include <fairlight/estimators/ranges.h>

namespace fairlight {

/// The map from the unit square to a triangle, uniform in the solid angle under which the origin
/// sees it. As in Arvo 1995, u_x chooses a point D on the edge AC so that the triangle ABD has the
/// fraction u_x of the solid angle, and u_y chooses a point of BD by its distance from B. Unlike
/// there, no step subtracts angles, so the triangle may be small, far away or seen at a grazing
/// angle.
template <class Real>
class SphericalTriangle {
  // Let a, b and c be the distances of the corners, E = B - A, F = C - A, and V = |A . (E x F)|, six
  // times the volume below the triangle. Then (van Oosterom and Strackee 1983)
  //   tan(S / 2) = V / (a b c + (A . B) c + (B . C) a + (C . A) b).
  // For ABD with D at the angle phi from A on the arc AC, with t = tan(S_D / 2) and C written by its
  // direction across A, the same formula is linear in tan(phi / 2):
  //   tan(phi / 2) = t (a b + A . B) |A x F| / (a V - t (A x E) . (A x F))
  // All that may be small is a product of edges, which are exact, not of directions. Lengths are
  // divided by the largest coordinate.
 public:
  /// The corner A and the edges E and F from it [m], as vectors from the origin, in any frame.
  /// `height` is the distance of the plane, unsigned, and `area` twice the triangle's [m^2].
  SphericalTriangle(const Vec3<Real>& corner, const Vec3<Real>& e, const Vec3<Real>& f, Real height,
                    Real twice_area)
      : scale_(largest(corner, e, f)),
        corner_(corner / scale_),
        e_(e / scale_),
        f_(f / scale_),
        a_(corner_.norm()),
        b_(Vec3<Real>(corner_ + e_).norm()) {
    using std::atan2;
    const Real c = Vec3<Real>(corner_ + f_).norm();
    const Real volume = height / scale_ * (twice_area / scale_ / scale_);
    seen_ = volume > Real(0) && a_ > Real(0) && b_ > Real(0) && c > Real(0);
    volume_ = select(seen_, volume, Real(1));
    const Vec3<Real> second = corner_ + e_, third = corner_ + f_;
    const Real below = a_ * b_ * c + corner_.dot(second) * c + second.dot(third) * a_ + third.dot(corner_) * b_;
    half_angle_ = atan2(volume_, below);
  }

  /// Whether the origin is off the plane and no corner is the origin.
  Mask<Real> seen() const { return seen_; }

  /// [sr]
  Real solid_angle() const { return Real(2) * half_angle_; }

  /// The unit of length of `at` [m].
  Real scale() const { return scale_; }

  /// The image of a point of the unit square, in units of `scale`.
  Vec3<Real> at(const Vec2<Real>& u) const {
    const Vec3<Real> second = corner_ + e_;
    const Vec3<Real> across = share_of_edge(u.x()) * f_ - e_;  // from B to D
    return second + share_of_arc(second, across, u.y()) * across;
  }

 private:
  static Real largest(const Vec3<Real>& corner, const Vec3<Real>& e, const Vec3<Real>& f) {
    using std::abs;
    using std::max;
    Real most = Real(0);
    for (int i = 0; i < 3; ++i) {
      most = max(most, Real(abs(corner[i])));
      most = max(most, Real(abs(Real(corner[i] + e[i]))));
      most = max(most, Real(abs(Real(corner[i] + f[i]))));
    }
    return most;
  }

  // The part g of a step from a point P at which P + g step is at the angle phi from P: by sines,
  // g = p^2 sin(phi) / (|P x step| cos(phi) - P . step sin(phi)).
  static Real part_at_angle(const Vec3<Real>& point, const Vec3<Real>& step, Real cross, Real sine, Real cosine) {
    const Real below = cross * cosine - point.dot(step) * sine;
    return point.squaredNorm() * sine / select(below > Real(0), below, Real(1));
  }

  // D = A + share * F.
  Real share_of_edge(Real u) const {
    using std::cos;
    using std::sin;
    const Real half = u * half_angle_;
    const Real s = sin(half), k = cos(half);
    const Vec3<Real> x = corner_.cross(e_), y = corner_.cross(f_);
    const Real cross = y.norm();
    // a b + A . B, which nearly cancels where A and B are opposite; |A x E| is then exact.
    const Real dot = corner_.dot(Vec3<Real>(corner_ + e_)), product = a_ * b_;
    const Real opposite = x.squaredNorm() / (product - select(dot < Real(0), dot, Real(0)));
    const Real sum = select(dot < Real(0), opposite, Real(product + dot));
    const Real n = s * sum * cross;
    const Real d = a_ * volume_ * k - s * x.dot(y);
    // phi / 2 has the tangent n / d, which is in [0, pi / 2].
    const Real q = n * n + d * d;
    const Real sine = Real(2) * n * d / q, cosine = (d - n) * (d + n) / q;
    return part_at_angle(corner_, f_, cross, sine, cosine);
  }

  // The point of BD whose 1 - cosine from B is the fraction u of that of D.
  static Real share_of_arc(const Vec3<Real>& second, const Vec3<Real>& across, Real u) {
    using std::max;
    using std::sqrt;
    const Vec3<Real> end = second + across;
    const Real cross = second.cross(across).norm();
    const Real dot = second.dot(end), product = second.norm() * end.norm();
    // Half of 1 - cosine of the whole arc.
    const Real steep = (product - dot) / (Real(2) * product);
    const Real flat = cross / product * (cross / (Real(2) * (product + select(dot > Real(0), dot, Real(0)))));
    const Real half = u * select(dot > Real(0), flat, steep);
    const Real sine = Real(2) * sqrt(Real(half * (Real(1) - half)));
    return part_at_angle(second, across, cross, sine, Real(Real(1) - Real(2) * half));
  }

  Real scale_;  ///< [m]
  Vec3<Real> corner_, e_, f_;
  Real a_, b_;  ///< distances of the first two corners
  Mask<Real> seen_;
  Real volume_;
  Real half_angle_;  ///< half of the solid angle [sr]
};

}  // namespace fairlight

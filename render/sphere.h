#pragma once

#include <utility>

#include <fairlight/estimators/vec.h>

namespace fairlight {

/// The first hit of a ray with a shape, as a fraction: the distance [m] is numerator / denominator.
/// No hit if either is not positive or is NaN. Hits are compared by cross products, as machines
/// have few units for division.
template <class Real>
struct RationalHit {
  Real numerator, denominator;

  /// No hit; every hit is before it.
  static RationalHit nowhere() { return {Real(infinity<Real>), Real(1)}; }

  Mask<Real> before(const RationalHit& other) const {
    return numerator > Real(0) && numerator * other.denominator < other.numerator * denominator;
  }

  /// Infinity for no hit.
  Real distance() const {
    const Real t = numerator / denominator;
    return select(t > Real(0), t, Real(infinity<Real>));
  }
};

/// A sphere in curvature form: the points x with k |x - a|^2 / 2 + n (x - a) = 0, where a is a
/// point of the sphere, n the outward unit normal at a, and k = 1/r. The centre and the radius,
/// which would cancel for a wall of radius 1e5, are not stored. k = 0 is the plane through a.
template <class Real>
struct Sphere {
  Vec3<Real> anchor;
  Vec3<Real> normal;
  Real curvature;

  /// The same sphere in every lane of a packet.
  template <class Other>
  Sphere<Other> in() const {
    return {anchor.template cast<Other>(), normal.template cast<Other>(), Other(curvature)};
  }

  /// The implicit function: 0 on the sphere, negative inside, near it the signed distance [m].
  Real level(const Vec3<Real>& x) const { return Real(0.5) * twice_implicit(x - anchor); }

  /// The outward unit normal at a point of the sphere.
  Vec3<Real> normal_at(const Vec3<Real>& x) const { return normal + curvature * (x - anchor); }

  /// The first hit along a unit direction. `leaving` marks lanes whose origin is on this sphere:
  /// their level is exactly 0, so the ray does not hit its start again, at any scale and without an
  /// epsilon.
  RationalHit<Real> crossing(const Vec3<Real>& origin, const Vec3<Real>& direction,
                             const Mask<Real>& leaving) const {
    using std::abs;
    using std::copysign;
    using std::max;
    using std::sqrt;
    const Line line = seen_from(origin, direction, leaving);
    // Solves k t^2 / 2 + slope t + level = 0, each root in the form that does not cancel. From
    // inside, or from the sphere itself with q > 0, the hit is q/k; otherwise it is 2 level / q. A
    // negative depth gives a NaN, a tangent or a plane gives 0/0 or q/0; none of these is before
    // another hit.
    const Real root = sqrt(line.depth);
    const Real q = -(line.slope + copysign(root, line.slope));
    const Mask<Real> across = max(line.twice_implicit, -q) <= Real(0);
    const Real over = select(across, q, line.twice_implicit);
    const Real under = select(across, curvature, q);
    return {over * copysign(Real(1), under), abs(under)};
  }

  /// For an origin inside or on the sphere, with k > 0: where the ray leaves it, and twice the
  /// level of the origin [m].
  std::pair<RationalHit<Real>, Real> exit(const Vec3<Real>& origin, const Vec3<Real>& direction,
                                          const Mask<Real>& leaving) const {
    using std::abs;
    using std::sqrt;
    const Line line = seen_from<false>(origin, direction, leaving);
    const Real sum = abs(line.slope) + sqrt(line.depth);
    const Mask<Real> inwards = line.slope < Real(0);
    return {{select(inwards, sum, Real(-line.twice_implicit)), select(inwards, curvature, sum)},
            line.twice_implicit};
  }

  /// For an origin outside or on the sphere: where the ray enters it, and twice the level of the
  /// origin [m].
  std::pair<RationalHit<Real>, Real> entry(const Vec3<Real>& origin, const Vec3<Real>& direction,
                                           const Mask<Real>& leaving) const {
    using std::sqrt;
    const Line line = seen_from(origin, direction, leaving);
    return {{line.twice_implicit, sqrt(line.depth) - line.slope}, line.twice_implicit};
  }

  /// Positive where the sphere stands on the ray closer than `reach` [m]. Needs no square root, and
  /// one comparison serves all spheres. The ray crosses the sphere once if the levels at its two
  /// ends have opposite signs. It crosses twice if both are positive and the point nearest to the
  /// centre, where the slope changes sign, is between the ends and inside. If the origin is on the
  /// sphere, the slope's sign gives its side.
  Real obstruction(const Vec3<Real>& origin, const Vec3<Real>& direction, const Mask<Real>& leaving,
                   Real reach) const {
    using std::max;
    using std::min;
    const Line line = seen_from(origin, direction, leaving);
    const Real slope_at_end = line.slope + curvature * reach;
    Real at_end = (slope_at_end + line.slope) * reach + line.twice_implicit;
    if (any(line.far)) at_end = select(line.far, Real(slope_at_end * slope_at_end - line.depth), at_end);
    const Real at_start = select(leaving, line.slope, line.twice_implicit);
    const Real turns = -line.slope * slope_at_end;
    return max(Real(-at_start * at_end), min(at_start, min(line.depth, turns)));
  }

 private:
  /// Along a ray, twice the level is twice_implicit + 2 slope t + k t^2. At every t, depth =
  /// slope^2 - k * (twice the level) = 1 - (distance of the line from the centre / radius)^2. For a
  /// sphere many radii away the two terms cancel: floats would see a sphere of 1 cm at 100 m as 3
  /// cm wide. There (`far`) depth comes from the gradient's component across the line, which does
  /// not cancel.
  /// Source   Haines, Guenther, Akenine-Moller 2019, "Precision improvements for ray/sphere
  /// intersection"
  struct Line {
    Real twice_implicit, slope, depth;
    Mask<Real> far;
  };

  template <bool may_be_far = true>
  Line seen_from(const Vec3<Real>& origin, const Vec3<Real>& direction, const Mask<Real>& leaving) const {
    const Vec3<Real> y = origin - anchor;
    const Vec3<Real> gradient = normal + curvature * y;
    const Real twice_implicit = select(leaving, Real(0), Real(y.dot(normal + gradient)));
    const Real slope = gradient.dot(direction);
    Real depth = slope * slope - curvature * twice_implicit;
    if constexpr (!may_be_far) return {twice_implicit, slope, depth, Mask<Real>(false)};
    const Mask<Real> far = curvature * twice_implicit > Real(4096);
    if (any(far)) {
      const Vec3<Real> across = gradient - slope * direction;
      depth = select(far, Real(Real(1) - across.squaredNorm()), depth);
    }
    return {twice_implicit, slope, depth, far};
  }

  Real twice_implicit(const Vec3<Real>& y) const { return y.dot(normal + normal + curvature * y); }
};

}  // namespace fairlight

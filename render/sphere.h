#pragma once

#include <utility>

#include <fairlight/estimators/vec.h>

namespace fairlight {

/// Where a ray first meets a shape ahead: the distance [m] as a fraction. Nowhere, if the numerator or the denominator is
/// not positive or no number. Two are compared by their products, as divisions are
/// what a machine does fewest of at once.
template <class Real>
struct RationalHit {
  Real numerator, denominator;

  /// Nowhere, which every other crossing is before.
  static RationalHit nowhere() { return {Real(infinity<Real>), Real(1)}; }

  Mask<Real> before(const RationalHit& other) const {
    return numerator > Real(0) && numerator * other.denominator < other.numerator * denominator;
  }

  /// Infinity for nowhere.
  Real distance() const {
    const Real t = numerator / denominator;
    return select(t > Real(0), t, Real(infinity<Real>));
  }
};

/// A sphere in curvature form: the points x with k |x - a|^2 / 2 + n (x - a) = 0, where a is a point of it, n the
/// outward unit normal there and k = 1/r. Centre and radius, which cancel each other for a wall of radius 1e5,
/// appear nowhere; k = 0 is the plane through a.
template <class Real>
struct Sphere {
  Vec3<Real> anchor;
  Vec3<Real> normal;
  Real curvature;

  /// The same for all lanes of a packet.
  template <class Other>
  Sphere<Other> in() const {
    return {anchor.template cast<Other>(), normal.template cast<Other>(), Other(curvature)};
  }

  /// Zero on the sphere, negative inside, near it the signed distance [m].
  Real level(const Vec3<Real>& x) const { return Real(0.5) * twice_implicit(x - anchor); }

  /// The outward unit normal at a point of the sphere.
  Vec3<Real> normal_at(const Vec3<Real>& x) const { return normal + curvature * (x - anchor); }

  /// The first point of the sphere ahead, along a unit direction. `leaving` says that the origin is on this very sphere: its
  /// level is then zero exactly, so the sphere is not hit again where the ray starts, at any scale, and there is no epsilon.
  RationalHit<Real> crossing(const Vec3<Real>& origin, const Vec3<Real>& direction,
                             const Mask<Real>& leaving) const {
    using std::abs;
    using std::copysign;
    using std::max;
    using std::sqrt;
    const Line line = seen_from(origin, direction, leaving);
    // k t^2 / 2 + slope t + level = 0, each root from the form that does not cancel: q/k is the one ahead from inside, or
    // from the sphere itself, where q is positive, and 2 level / q otherwise. A negative depth makes a NaN, and a tangent or a
    // plane 0/0 or q/0, none of which comes before anything.
    const Real root = sqrt(line.depth);
    const Real q = -(line.slope + copysign(root, line.slope));
    const Mask<Real> across = max(line.twice_implicit, -q) <= Real(0);
    const Real over = select(across, q, line.twice_implicit);
    const Real under = select(across, curvature, q);
    return {over * copysign(Real(1), under), abs(under)};
  }

  /// Of an origin that is inside or on the sphere, which is no plane: where the ray leaves it, and twice the level of the origin [m].
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

  /// Of an origin that is outside or on the sphere: where the ray enters it, and twice the level of the origin [m].
  std::pair<RationalHit<Real>, Real> entry(const Vec3<Real>& origin, const Vec3<Real>& direction,
                                           const Mask<Real>& leaving) const {
    using std::sqrt;
    const Line line = seen_from(origin, direction, leaving);
    return {{line.twice_implicit, sqrt(line.depth) - line.slope}, line.twice_implicit};
  }

  /// Positive where the sphere stands on the ray closer than `reach` [m], without a root and with one comparison for all
  /// spheres together: it is passed once when the levels at the two ends are of opposite signs, and twice when both are positive but
  /// the ray's nearest point to the centre, where the slope changes its sign, is between them and not outside. Where the
  /// origin is on the sphere its side is that of the slope.
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
  /// Along a ray, twice the level is twice_implicit + 2 slope t + k t^2. The square of the slope less k times twice the level is
  /// the same at every t: the depth, 1 less the square of the line's distance from the centre in radii. Of a sphere that is
  /// farther than some of its radii the two cancel, and floats would see one of 1 cm from 100 m as wide as 3 cm; what the
  /// gradient has across the line does not.
  /// Source   Haines, Guenther, Akenine-Moller 2019, "Precision improvements for ray/sphere intersection"
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

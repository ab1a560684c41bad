#pragma once

#include <fairlight/estimators/vec.h>

namespace fairlight {

/// A sphere in curvature form: the points x with k |x - a|^2 / 2 + n (x - a) = 0, where a is a point of it, n the
/// outward unit normal there and k = 1/r. Centre and radius, which cancel each other for a wall of radius 1e5,
/// appear nowhere; k = 0 is the plane through a.
template <class Real>
struct Sphere {
  Vec3<Real> anchor;
  Vec3<Real> normal;
  Real curvature;

  /// Zero on the sphere, negative inside, near it the signed distance [m].
  Real level(const Vec3<Real>& x) const {
    const Vec3<Real> y = x - anchor;
    return Real(0.5) * curvature * y.squaredNorm() + normal.dot(y);
  }

  /// The outward unit normal at a point of the sphere.
  Vec3<Real> normal_at(const Vec3<Real>& x) const { return normal + curvature * (x - anchor); }

  /// Along a unit direction, the distance [m] to the first point of the sphere ahead; infinity where there is none.
  /// `leaving` says that the origin is on this very sphere: its level is then zero exactly, so the sphere is not
  /// hit again where the ray starts, at any scale, and there is no epsilon.
  Real distance(const Vec3<Real>& origin, const Vec3<Real>& direction, const Mask<Real>& leaving) const {
    using std::copysign;
    using std::sqrt;
    const Vec3<Real> y = origin - anchor;
    const Vec3<Real> gradient = normal + curvature * y;
    const Real level = select(leaving, Real(0), Real(Real(0.5) * curvature * y.squaredNorm() + normal.dot(y)));
    const Real slope = gradient.dot(direction);
    // k t^2 / 2 + slope t + level = 0, each root from the form that does not cancel. A negative discriminant, or
    // 0/0 on a tangent or a plane, makes a NaN, which no comparison takes for a hit.
    const Real root = sqrt(slope * slope - Real(2) * curvature * level);
    const Real q = -(slope + copysign(root, slope));
    const Real far = q / curvature;
    const Real near = Real(2) * level / q;
    Real nearest = select(far > Real(0), far, infinity<Real>);
    nearest = select((near > Real(0)) & (near < nearest), near, nearest);
    return nearest;
  }
};

}  // namespace fairlight

#pragma once

#include <fairlight/render/sphere.h>

namespace fairlight {

/// A rectangle centred on the anchor of its plane: the points of the plane whose coordinates along
/// the axes x and y are in [-1, 1]. The axes are orthogonal to each other and to the normal; their
/// length is 2 / edge length [1/m].
template <class Real>
struct Rectangle {
  Sphere<Real> plane;
  Vec3<Real> x, y;

  /// The same rectangle in every lane of a packet.
  template <class Other>
  Rectangle<Other> in() const {
    return {plane.template in<Other>(), x.template cast<Other>(), y.template cast<Other>()};
  }

  /// The hit along a unit direction; nowhere if the origin is on the rectangle.
  RationalHit<Real> crossing(const Vec3<Real>& origin, const Vec3<Real>& direction,
                             const Mask<Real>& leaving) const {
    using std::abs;
    const Real slope = plane.normal.dot(direction);
    const Vec3<Real> to_anchor = plane.anchor - origin;
    const Real t = plane.normal.dot(to_anchor) / slope;
    const Mask<Real> ahead = t > Real(0) && !leaving;
    const Vec3<Real> place = direction * select(ahead, t, Real(0)) - to_anchor;
    const Mask<Real> within = abs(x.dot(place)) <= Real(1) && abs(y.dot(place)) <= Real(1);
    return {select(ahead && within, t, Real(0)), Real(1)};
  }

  /// Positive where the rectangle stands on the ray closer than `reach` [m].
  Real obstruction(const Vec3<Real>& origin, const Vec3<Real>& direction, const Mask<Real>& leaving,
                   Real reach) const {
    return reach - crossing(origin, direction, leaving).distance();
  }
};

}  // namespace fairlight

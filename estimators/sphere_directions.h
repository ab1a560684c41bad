#pragma once

#include <fairlight/estimators/density.h>
#include <fairlight/estimators/polar.h>

namespace fairlight {

/// Uniform directions on the whole sphere.
/// Formula  p(w) = 1 / (4 pi)
/// Measure  solid angle [1/sr]
/// Domain   unit vectors
/// Random   u in [0,1)^2
/// Source   Archimedes (equal areas at equal heights); Pharr, Jakob, Humphreys, PBR 4ed, A.5.2
template <class Real>
struct UniformSphere {
  using Scalar = Real;
  using Point = Vec3<Real>;
  using Measure = SolidAngle;

  Point sample(const Vec2<Real>& u) const { return detail::direction_below_pole(Real(Real(2) * u.x()), u.y()); }

  Vec2<Real> invert(const Point& w) const {
    return {detail::drop_below_pole(w) / Real(2), detail::turn_about_z(w)};
  }

  Density<Measure, Real> pdf(const Point&) const {
    return Density<Measure, Real>(Real(Real(1) / (Real(4) * pi<Real>)));
  }
};

}  // namespace fairlight

#pragma once

#include <fairlight/estimators/density.h>
#include <fairlight/estimators/polar.h>

namespace fairlight {

/// Uniform directions about +z.
/// Formula  p(w) = 1 / (2 pi)
/// Measure  solid angle [1/sr]
/// Domain   unit vectors in the local frame, z >= 0; the density is 0 elsewhere
/// Random   u in [0,1)^2
/// Source   Pharr, Jakob, Humphreys, PBR 4ed, A.5.2
template <class Real>
struct UniformHemisphere {
  using Scalar = Real;
  using Point = Vec3<Real>;
  using Measure = SolidAngle;

  Point sample(const Vec2<Real>& u) const {
    using std::sqrt;
    const Real z = u.x();
    return detail::direction_at(z, Real(sqrt((Real(1) - z) * (Real(1) + z))), u.y());
  }

  /// The u that `sample` maps to w, to rounding. So are all functions named `invert`.
  Vec2<Real> invert(const Point& w) const { return {w.z(), detail::turn_about_z(w)}; }

  Density<Measure, Real> pdf(const Point& w) const {
    return Density<Measure, Real>(select(w.z() >= Real(0), Real(1) / (Real(2) * pi<Real>), Real(0)));
  }
};

/// Cosine-weighted directions about +z.
/// Formula  p(w) = cos(theta) / pi
/// Measure  solid angle [1/sr]
/// Domain   unit vectors in the local frame, z >= 0; the density is 0 elsewhere
/// Random   u in [0,1)^2
/// Source   Pharr, Jakob, Humphreys, PBR 4ed, A.5.3 (Malley's method, on the polar map)
template <class Real>
struct CosineHemisphere {
  using Scalar = Real;
  using Point = Vec3<Real>;
  using Measure = SolidAngle;

  /// z = sqrt(1 - u_x) > 0, so a sampled direction never has density zero.
  Point sample(const Vec2<Real>& u) const {
    using std::sqrt;
    return detail::direction_at(Real(sqrt(Real(1) - u.x())), Real(sqrt(u.x())), u.y());
  }

  Vec2<Real> invert(const Point& w) const { return {w.x() * w.x() + w.y() * w.y(), detail::turn_about_z(w)}; }

  Density<Measure, Real> pdf(const Point& w) const {
    return Density<Measure, Real>(select(w.z() > Real(0), Real(w.z() * (Real(1) / pi<Real>)), Real(0)));
  }
};

}  // namespace fairlight

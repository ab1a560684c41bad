#pragma once

#include <fairlight/estimators/density.h>
#include <fairlight/estimators/vec.h>

namespace fairlight {

namespace detail {

/// The unit vector at height z above the equator, at the fraction `turn` of a full turn about +z.
template <class Real>
Vec3<Real> direction_at(Real z, Real radius, Real turn) {
  const auto [sine, cosine] = sine_and_cosine(Real(Real(2) * pi<Real> * turn));
  return {radius * cosine, radius * sine, z};
}

}  // namespace detail

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

  Density<Measure, Real> pdf(const Point& w) const {
    return Density<Measure, Real>(select(w.z() > Real(0), Real(w.z() / pi<Real>), Real(0)));
  }
};

}  // namespace fairlight

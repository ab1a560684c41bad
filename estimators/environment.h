#pragma once

#include <fairlight/estimators/hemisphere.h>
#include <fairlight/estimators/light_sample.h>

namespace fairlight {

/// An environment of one radiance in every direction, infinitely far away.
/// Formula  p(w) = 1 / (4 pi)
/// Measure  solid angle [1/sr]
/// Domain   unit vectors, all of them
/// Random   u in [0,1)^2
/// Source   Archimedes (equal areas at equal heights); Pharr, Jakob, Humphreys, PBR 4ed, 12.5.1
template <class Real>
class ConstantEnvironment {
 public:
  using Scalar = Real;

  LightSample<Real> sample(const Vec3<Real>& from, const Vec2<Real>& u) const {
    using std::sqrt;
    const Real z = Real(1) - Real(2) * u.x();
    const Real ring = Real(2) * sqrt(u.x() * (Real(1) - u.x()));
    const Vec3<Real> direction = detail::direction_at(z, ring, u.y());
    return {direction, Real(infinity<Real>), pdf(from, direction)};
  }

  Density<SolidAngle, Real> pdf(const Vec3<Real>&, const Vec3<Real>&) const {
    return Density<SolidAngle, Real>(Real(1) / (Real(4) * pi<Real>));
  }
};

}  // namespace fairlight

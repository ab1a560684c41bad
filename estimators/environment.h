#pragma once

#include <fairlight/estimators/light_sample.h>
#include <fairlight/estimators/sphere_directions.h>

namespace fairlight {

/// An environment at infinity with the same radiance in every direction.
/// Formula  p(w) = 1 / (4 pi)
/// Measure  solid angle [1/sr]
/// Domain   all unit vectors
/// Random   u in [0,1)^2
/// Source   Archimedes (equal areas at equal heights); Pharr, Jakob, Humphreys, PBR 4ed, 12.5.1
template <class Real>
class ConstantEnvironment {
 public:
  using Scalar = Real;

  LightSample<Real> sample(const Vec3<Real>& from, const Vec2<Real>& u) const {
    const Vec3<Real> direction = UniformSphere<Real>().sample(u);
    return {direction, Real(infinity<Real>), pdf(from, direction)};
  }

  Density<SolidAngle, Real> pdf(const Vec3<Real>&, const Vec3<Real>& direction) const {
    return UniformSphere<Real>().pdf(direction);
  }
};

}  // namespace fairlight

#pragma once

#include <fairlight/estimators/rectangle_light.h>
#include <fairlight/estimators/sphere_sampling.h>

/// Wrong light sampling at some distances alone. Each fault replaces a right strategy.
namespace fairlight::faults {

/// Counts the distance to a light as at least 0.1 m, against "fireflies" in corners.
template <class Strategy>
struct DistanceFloored : Strategy {
  using Real = typename Strategy::Scalar;
  using Strategy::Strategy;
  LightSample<Real> sample(const Vec3<Real>& from, const Vec2<Real>& u) const {
    LightSample<Real> sample = Strategy::sample(from, u);
    const Real longer = rounded<Real>(0.1) / sample.distance;
    const Real factor = select(longer > Real(1), Real(longer * longer), Real(1));
    sample.density = Density<SolidAngle, Real>(sample.density.value() * factor);
    return sample;
  }
};
template <class Real>
using RectangleFloored = DistanceFloored<RectangleByArea<Real>>;
template <class Real>
using SphereFloored = DistanceFloored<SphereByVisibleHemisphere<Real>>;

/// Adds a millionth of a square metre to the squared distance, against a division by 0.
template <class Real>
struct SphereSquareFloored : SphereByVisibleHemisphere<Real> {
  using SphereByVisibleHemisphere<Real>::SphereByVisibleHemisphere;
  LightSample<Real> sample(const Vec3<Real>& from, const Vec2<Real>& u) const {
    LightSample<Real> sample = SphereByVisibleHemisphere<Real>::sample(from, u);
    const Real square = sample.distance * sample.distance;
    sample.density = Density<SolidAngle, Real>(sample.density.value() * ((square + rounded<Real>(1e-6)) / square));
    return sample;
  }
};

/// Looks for lights within a kilometre only.
template <class Real>
struct SphereOfAKilometre : SphereByVisibleHemisphere<Real> {
  using SphereByVisibleHemisphere<Real>::SphereByVisibleHemisphere;
  LightSample<Real> sample(const Vec3<Real>& from, const Vec2<Real>& u) const {
    LightSample<Real> sample = SphereByVisibleHemisphere<Real>::sample(from, u);
    const Mask<Real> near = sample.distance < Real(1000);
    sample.density = Density<SolidAngle, Real>(select(near, sample.density.value(), Real(0)));
    return sample;
  }
};

/// A rectangle that shines from one face alone.
template <class Real>
struct RectangleOneSided : RectangleByArea<Real> {
  explicit RectangleOneSided(const RectangleLight<Real>& light) : RectangleByArea<Real>(light), rectangle(light) {}
  LightSample<Real> sample(const Vec3<Real>& from, const Vec2<Real>& u) const {
    LightSample<Real> sample = RectangleByArea<Real>::sample(from, u);
    const Mask<Real> front = rectangle.corner_from(from).z() > Real(0);
    sample.density = Density<SolidAngle, Real>(select(front, sample.density.value(), Real(0)));
    return sample;
  }
  RectangleLight<Real> rectangle;
};

}  // namespace fairlight::faults

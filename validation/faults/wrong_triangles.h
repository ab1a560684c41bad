#pragma once

#include <fairlight/estimators/triangle_light.h>

/// Wrong sampling of triangles. Each fault replaces a right strategy.
namespace fairlight::faults {

/// Forgets the root of the first number, so that points crowd at a corner.
template <class Real>
struct TriangleWithoutRoot : TriangleByArea<Real> {
  using TriangleByArea<Real>::TriangleByArea;
  LightSample<Real> sample(const Vec3<Real>& from, const Vec2<Real>& u) const {
    return TriangleByArea<Real>::sample(from, {Real(u.x() * u.x()), u.y()});
  }
};

/// Takes the area of the parallelogram for the triangle's.
template <class Real>
struct TriangleOfTwiceTheArea : TriangleByArea<Real> {
  using TriangleByArea<Real>::TriangleByArea;
  LightSample<Real> sample(const Vec3<Real>& from, const Vec2<Real>& u) const {
    LightSample<Real> sample = TriangleByArea<Real>::sample(from, u);
    sample.density = Density<SolidAngle, Real>(sample.density.value() / Real(2));
    return sample;
  }
};

}  // namespace fairlight::faults

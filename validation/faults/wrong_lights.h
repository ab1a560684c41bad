#pragma once

#include <fairlight/estimators/choose_light.h>
#include <fairlight/estimators/rectangle_light.h>
#include <fairlight/estimators/sphere_sampling.h>

/// Wrong light sampling. Each fault replaces a right strategy.
namespace fairlight::faults {

/// The solid angle of a sphere with a hard-coded radius of 1 m.
/// On record: Smerity/montelight-cpp.
template <class Real>
struct RadiusWrittenIn : SphereByCone<Real> {
  using SphereByCone<Real>::SphereByCone;
  LightSample<Real> sample(const Vec3<Real>& from, const Vec2<Real>& u) const {
    LightSample<Real> sample = SphereByCone<Real>::sample(from, u);
    sample.density = SphereByCone<Real>(SphereLight<Real>({Real(1), Real(2), rounded<Real>(2.5)}, Real(1)))
                         .sample(from, u)
                         .density;
    return sample;
  }
};

/// Converts area to solid angle by the square of the distance alone, without the cosine at the
/// light.
/// On record: the class of Baikal #82 and AdaPT #22.
template <class Real>
struct CosineMissing : SphereByVisibleHemisphere<Real> {
  explicit CosineMissing(const SphereLight<Real>& sphere)
      : SphereByVisibleHemisphere<Real>(sphere), radius(sphere.radius()) {}
  LightSample<Real> sample(const Vec3<Real>& from, const Vec2<Real>& u) const {
    LightSample<Real> sample = SphereByVisibleHemisphere<Real>::sample(from, u);
    const Real constant = sample.distance * sample.distance / (Real(2) * pi<Real> * radius * radius);
    sample.density = Density<SolidAngle, Real>(select(sample.density.value() > Real(0), constant, Real(0)));
    return sample;
  }
  Real radius;
};

/// Takes the density of a rectangle per area for one per solid angle.
/// On record: the class of pbrt-v4 d86222e6.
template <class Real>
struct AreaForSolidAngle : RectangleByArea<Real> {
  explicit AreaForSolidAngle(const RectangleLight<Real>& rectangle)
      : RectangleByArea<Real>(rectangle), area(rectangle.area()) {}
  LightSample<Real> sample(const Vec3<Real>& from, const Vec2<Real>& u) const {
    LightSample<Real> sample = RectangleByArea<Real>::sample(from, u);
    sample.density = Density<SolidAngle, Real>(Real(1) / area);
    return sample;
  }
  Real area;
};

/// Picks a light by its power, but divides by the uniform probability.
/// On record: the class of ospray #552.
template <class Real>
struct PowerWeightedByNumber : PowerChoice<Real> {
  using PowerChoice<Real>::PowerChoice;
  Pick<Real> sample(const Vec2<Real>& u) const {
    return {PowerChoice<Real>::sample(u).index, Density<Discrete, Real>(Real(1) / rounded<Real>(this->size()))};
  }
};

/// Converts area to solid angle by the distance instead of its square.
/// On record: the class of Baikal #82.
template <class Real>
struct DistanceNotSquared : SphereByVisibleHemisphere<Real> {
  using SphereByVisibleHemisphere<Real>::SphereByVisibleHemisphere;
  LightSample<Real> sample(const Vec3<Real>& from, const Vec2<Real>& u) const {
    LightSample<Real> sample = SphereByVisibleHemisphere<Real>::sample(from, u);
    sample.density = Density<SolidAngle, Real>(sample.density.value() / sample.distance);
    return sample;
  }
};

/// Points on the visible half, with the density of the whole sphere.
/// On record: the class of raytracing.github.io #145.
template <class Real>
struct HalfWithDensityOfWhole : SphereByVisibleHemisphere<Real> {
  using SphereByVisibleHemisphere<Real>::SphereByVisibleHemisphere;
  LightSample<Real> sample(const Vec3<Real>& from, const Vec2<Real>& u) const {
    LightSample<Real> sample = SphereByVisibleHemisphere<Real>::sample(from, u);
    sample.density = Density<SolidAngle, Real>(sample.density.value() / Real(2));
    return sample;
  }
};

/// Compares the random number with the probability of each light, not with the cumulative sum.
/// On record: UnitySSPathTracingURP #8.
template <class Real>
struct ThresholdsNotCumulative : PowerChoice<Real> {
  using PowerChoice<Real>::PowerChoice;
  Pick<Real> sample(const Vec2<Real>& u) const {
    Real index = rounded<Real>(this->size() - 1);
    for (int i = this->size() - 1; i >= 0; --i) {
      index = select(u.x() < this->probability(Index<Real>(i)), rounded<Real>(i), index);
    }
    return {to_int(index), Density<Discrete, Real>(this->probability(to_int(index)))};
  }
};

}  // namespace fairlight::faults

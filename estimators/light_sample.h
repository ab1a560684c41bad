#pragma once

#include <concepts>

#include <fairlight/estimators/safe_divide.h>

namespace fairlight {

/// A direction in which a light is seen from a point. See safe_divide for what to divide by the density.
template <class Real>
struct LightSample {
  Vec3<Real> direction;               ///< in the world, unit, towards the light
  Real distance;                      ///< to the light [m], may be infinite
  Density<SolidAngle, Real> density;  ///< [1/sr]; 0 where the sample does not exist, and the rest then says nothing
};

/// A way to choose directions towards a light: `sample(from, u)`, a pure function of the point that is lit and of a
/// point of the unit square, and `pdf(from, direction)`, the density of what it gives. Where some samples do not
/// exist, the density integrates to less than one. The direction of `pdf` is a unit vector to rounding, and neither checked
/// nor made one: of one that is too long by a small part e the density is off by some e, and one of another length has none.
template <class T>
concept LightSampling = requires(const T light, Vec3<typename T::Scalar> x, Vec2<typename T::Scalar> u) {
  { light.sample(x, u) } -> std::same_as<LightSample<typename T::Scalar>>;
  { light.pdf(x, x) } -> std::same_as<Density<SolidAngle, typename T::Scalar>>;
};

}  // namespace fairlight

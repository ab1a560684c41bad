#pragma once

#include <concepts>

#include <fairlight/estimators/ranges.h>
#include <fairlight/estimators/safe_divide.h>

namespace fairlight {

/// A direction from a point to a light. Use safe_divide to divide by the density.
template <class Real>
struct LightSample {
  Vec3<Real> direction;               ///< unit vector in the world, towards the light
  Real distance;                      ///< to the light [m]; may be infinite
  Density<SolidAngle, Real> density;  ///< [1/sr]; if 0, the sample does not exist, and the rest has no meaning
};

/// The largest density of a direction to a rectangle or a triangle [1/sr]. Where it would be larger,
/// as the solid angle is nearly 0, the light counts as invisible, as it is from its own plane.
template <class Real>
inline constexpr Lane<Real> largest_density = in_floats<Real> ? Lane<Real>(1e36) : Lane<Real>(1e280);

/// Samples directions from a point towards a light. `sample(from, u)` is a pure function of the lit
/// point and of a point u of the unit square. `pdf(from, direction)` is its density, which
/// integrates to less than 1 if some samples do not exist. `pdf` neither checks nor normalises the
/// direction, a unit vector to rounding. A relative error e in its length gives a relative error of
/// about e in the density; for any other length the density has no meaning.
template <class T>
concept LightSampling = requires(const T light, Vec3<typename T::Scalar> x, Vec2<typename T::Scalar> u) {
  { light.sample(x, u) } -> std::same_as<LightSample<typename T::Scalar>>;
  { light.pdf(x, x) } -> std::same_as<Density<SolidAngle, typename T::Scalar>>;
};

}  // namespace fairlight

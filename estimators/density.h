#pragma once

#include <concepts>

namespace fairlight {

/// The measures of densities.
struct SolidAngle {};  ///< [1/sr]
struct Area {};        ///< [1/m^2]; on the image plane [1/pixel^2]
struct UnitCube {};    ///< Lebesgue measure on [0,1)^n, dimensionless
struct Discrete {};    ///< counting measure; the density is a probability

/// A probability density, tagged with its measure. Densities of different measures do not mix; a
/// named function changes the measure, given the distance and the cosine.
template <class Measure, class Real>
class Density {
 public:
  explicit Density(Real value) : value_(value) {}
  Real value() const { return value_; }

 private:
  Real value_;
};

/// One draw's estimate of an integral: f(x) / p(x).
template <class Value, class Measure, class Real>
auto operator/(const Value& integrand, Density<Measure, Real> density) {
  return integrand / density.value();
}

/// The density of choosing one of several samplers, and then sampling from it.
template <class Measure, class Real>
Density<Measure, Real> operator*(Density<Discrete, Real> choice, Density<Measure, Real> density) {
  return Density<Measure, Real>(choice.value() * density.value());
}

/// p_w = p_A d^2 / cos. `distance` is that to the point [m]. `cosine` in (0,1] is between the
/// surface's normal there and the direction back. If the cosine is not positive, the surface is not
/// visible and the density means nothing.
template <class Real>
Density<SolidAngle, Real> to_solid_angle(Density<Area, Real> density, Real distance, Real cosine) {
  return Density<SolidAngle, Real>(density.value() * (distance * distance) / cosine);
}

/// p_A = p_w cos / d^2, the inverse of to_solid_angle.
template <class Real>
Density<Area, Real> to_area(Density<SolidAngle, Real> density, Real distance, Real cosine) {
  return Density<Area, Real>(density.value() * cosine / (distance * distance));
}

}  // namespace fairlight

#pragma once

#include <concepts>

namespace fairlight {

/// The measures that densities are taken against.
struct SolidAngle {};           ///< [1/sr]
struct ProjectedSolidAngle {};  ///< [1/sr], against cos(theta) dw
struct Area {};                 ///< [1/m^2]; on the image plane, [1/pixel^2]
struct UnitCube {};             ///< against Lebesgue measure on [0,1)^n, dimensionless
struct Discrete {};             ///< a probability, against counting measure

/// A probability density, tagged with its measure. Densities of different measures do not mix: the change of
/// measure is a named function that takes the distance and the cosine.
template <class Measure, class Real>
class Density {
 public:
  explicit Density(Real value) : value_(value) {}
  Real value() const { return value_; }

 private:
  Real value_;
};

/// An estimate of an integral from one draw: f(x) / p(x).
template <class Value, class Measure, class Real>
auto operator/(const Value& integrand, Density<Measure, Real> density) {
  return integrand / density.value();
}

/// The density of first choosing one of several samplers, then drawing from it.
template <class Measure, class Real>
Density<Measure, Real> operator*(Density<Discrete, Real> choice, Density<Measure, Real> density) {
  return Density<Measure, Real>(choice.value() * density.value());
}

/// p_w = p_A d^2 / cos. `distance` in m to the point; `cosine` in (0,1] between the surface's normal there and the
/// direction back; the density is meaningless where the cosine is not positive, as the surface is not seen from
/// there.
template <class Real>
Density<SolidAngle, Real> to_solid_angle(Density<Area, Real> density, Real distance, Real cosine) {
  return Density<SolidAngle, Real>(density.value() * (distance * distance) / cosine);
}

/// p_A = p_w cos / d^2, the inverse of to_solid_angle.
template <class Real>
Density<Area, Real> to_area(Density<SolidAngle, Real> density, Real distance, Real cosine) {
  return Density<Area, Real>(density.value() * cosine / (distance * distance));
}

/// p_perp = p_w / cos, with the cosine at the surface that receives.
template <class Real>
Density<ProjectedSolidAngle, Real> to_projected_solid_angle(Density<SolidAngle, Real> density, Real cosine) {
  return Density<ProjectedSolidAngle, Real>(density.value() / cosine);
}

}  // namespace fairlight

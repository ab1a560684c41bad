#pragma once

#include <stdexcept>

#include <fairlight/estimators/density.h>
#include <fairlight/estimators/polar.h>

namespace fairlight {

/// Uniform directions in a cone about +z, such as a sphere light, the sun's disk or an aperture
/// subtends. The parameter is 1 - cos(theta_max), and no step subtracts cosines: a cone of 1e-8 rad
/// has the same relative accuracy as a wide one.
/// Formula  p(w) = 1 / (2 pi (1 - cos(theta_max)))
/// Measure  solid angle [1/sr]
/// Domain   unit vectors with theta <= theta_max <= pi, to rounding; the density is 0 elsewhere
/// Random   u in [0,1)^2
/// Source   Shirley, Wang, Zimmerman 1996, 3.2; the cancellation: pbrt-v3 #212
template <class Real>
class UniformCone {
 public:
  using Scalar = Real;
  using Point = Vec3<Real>;
  using Measure = SolidAngle;

  /// `height` is 1 - cos(theta_max), in (0,2]; throws std::invalid_argument otherwise.
  explicit UniformCone(Real height) : height_(height) {
    if (!all_positive(height) || !all(height <= Real(2))) {
      throw std::invalid_argument("a cone's height 1 - cos must be in (0,2] (its solid angle divides)");
    }
  }

  /// From sin^2(theta_max) in (0,1], with theta_max <= pi/2. For a sphere of radius r at the
  /// distance d it is r^2/d^2.
  static UniformCone of_sine_squared(Real sine_squared) {
    using std::sqrt;
    if (!all_positive(sine_squared) || !all(sine_squared <= Real(1))) {
      throw std::invalid_argument(
          "the squared sine of a cone's half angle must be in (0,1] (a sphere is seen as a "
          "cone only from outside)");
    }
    return UniformCone(sine_squared / (Real(1) + sqrt(Real(1) - sine_squared)));
  }

  /// [sr]
  Real solid_angle() const { return Real(2) * pi<Real> * height_; }

  Point sample(const Vec2<Real>& u) const { return detail::direction_below_pole(Real(height_ * u.x()), u.y()); }

  Vec2<Real> invert(const Point& w) const {
    return {detail::drop_below_pole(w) / height_, detail::turn_about_z(w)};
  }

  /// The support includes directions that rounding moves past the edge, so no sampled direction has
  /// density 0. From the height to a direction and back the rounding errors add up to less than 16
  /// ulp, with sine and cosine accurate to 2 ulp.
  Density<Measure, Real> pdf(const Point& w) const {
    const Real edge = height_ * (Real(1) + Real(16) * ulp<Real>);
    return Density<Measure, Real>(
        select(detail::drop_below_pole(w) <= edge, Real(Real(1) / solid_angle()), Real(0)));
  }

 private:
  Real height_;
};

}  // namespace fairlight

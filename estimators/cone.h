#pragma once

#include <stdexcept>

#include <fairlight/estimators/density.h>
#include <fairlight/estimators/polar.h>

namespace fairlight {

/// Uniform directions in a cone about +z: what a sphere light subtends, a sun's disk, an aperture. The cone is
/// given by the height of its cap, 1 - cos(theta_max), and no step subtracts cosines: a cone of 1e-8 rad is as
/// exact as a wide one.
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

  /// Of the height 1 - cos(theta_max), in (0,2]; throws std::invalid_argument otherwise.
  explicit UniformCone(Real height) : height_(height) {
    if (!all_positive(height) || !all(height <= Real(2))) {
      throw std::invalid_argument("a cone's height 1 - cos must be in (0,2] (its solid angle divides)");
    }
  }

  /// Of sin^2(theta_max) in (0,1], theta_max at most pi/2: for a sphere of radius r at the distance d, r^2/d^2.
  static UniformCone of_sine_squared(Real sine_squared) {
    using std::sqrt;
    if (!all_positive(sine_squared) || !all(sine_squared <= Real(1))) {
      throw std::invalid_argument(
          "the squared sine of a cone's half angle must be in (0,1] (a sphere is seen as a "
          "cone only from outside)");
    }
    return UniformCone(sine_squared / (Real(1) + sqrt(Real(1) - sine_squared)));
  }

  /// Of theta_max in (0,pi] rad.
  static UniformCone of_half_angle(Real theta) {
    using std::sin;
    if (!all_positive(theta) || !all(theta <= Real(pi<Real>))) {
      throw std::invalid_argument("a cone's half angle must be in (0,pi] (its solid angle divides)");
    }
    const Real half = sin(theta / Real(2));
    return UniformCone(Real(2) * half * half);
  }

  /// [sr]
  Real solid_angle() const { return Real(2) * pi<Real> * height_; }

  Point sample(const Vec2<Real>& u) const { return detail::direction_below_pole(Real(height_ * u.x()), u.y()); }

  Vec2<Real> invert(const Point& w) const {
    return {detail::drop_below_pole(w) / height_, detail::turn_about_z(w)};
  }

  /// The cone includes the directions that rounding takes past its edge, so that none that is drawn has density
  /// zero: from height to direction and back the roundings add up to less than 16 ulp, sine and cosine being good
  /// to 2.
  Density<Measure, Real> pdf(const Point& w) const {
    const Real edge = height_ * (Real(1) + Real(16) * ulp<Real>);
    return Density<Measure, Real>(
        select(detail::drop_below_pole(w) <= edge, Real(Real(1) / solid_angle()), Real(0)));
  }

 private:
  Real height_;
};

}  // namespace fairlight

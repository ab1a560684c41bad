#pragma once

#include <fairlight/estimators/concepts.h>
#include <fairlight/estimators/hemisphere.h>

namespace fairlight {

/// A diffuse surface, seen from the side of its local +z.
/// Formula  f = albedo / pi, without the cosine; sampled by Directions
/// Measure  f in 1/sr; the density is that of Directions, in solid angle
/// Domain   incoming and outgoing directions with z > 0; f is 0 elsewhere; albedo in [0,1] per channel
/// Random   u in [0,1)^2
/// Source   Lambert 1760; the paper, 3.1
template <class Real, template <class> class Directions = CosineHemisphere>
class Lambertian {
 public:
  struct Bounce {
    Vec3<Real> direction;  ///< local, unit
    Rgb<Real> weight;      ///< f cos / p
  };

  explicit Lambertian(const Rgb<Real>& albedo) : albedo_(albedo) {}

  /// The BRDF for light from the direction w (local, unit).
  Rgb<Real> eval(const Vec3<Real>& w) const {
    return albedo_ * select(w.z() > Real(0), Real(1) / pi<Real>, Real(0));
  }

  Density<SolidAngle, Real> pdf(const Vec3<Real>& w) const { return directions_.pdf(w); }

  Bounce sample(const Vec2<Real>& u) const {
    const Vec3<Real> w = directions_.sample(u);
    return {w, Rgb<Real>(eval(w) * w.z() / pdf(w))};
  }

 private:
  Rgb<Real> albedo_;
  Directions<Real> directions_;
};

}  // namespace fairlight

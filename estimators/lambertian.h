#pragma once

#include <fairlight/estimators/bsdf.h>
#include <fairlight/estimators/hemisphere.h>

namespace fairlight {

/// A diffuse surface.
/// Formula  f = albedo / pi, without the cosine; sampled by Directions
/// Measure  f in 1/sr; the density is that of Directions, in solid angle
/// Domain   directions with z > 0, f is 0 elsewhere; albedo in [0,1] per channel
/// Random   u in [0,1)^2
/// Source   Lambert 1760; the paper, 3.1
template <class Real, template <class> class Directions = CosineHemisphere>
class Lambertian {
 public:
  using Scalar = Real;
  static constexpr int dimensions = 2;

  /// Throws std::invalid_argument for an albedo outside [0,1].
  explicit Lambertian(const Rgb<Real>& albedo, const Directions<Real>& directions = Directions<Real>())
      : albedo_(albedo), directions_(directions) {
    require_albedo(albedo);
  }

  /// The same for all directions above the surface.
  Rgb<Real> albedo(const Vec3<Real>& out) const { return albedo_ * select(out.z() > Real(0), Real(1), Real(0)); }

  Rgb<Real> eval(const Vec3<Real>& out, const Vec3<Real>& in) const {
    return albedo_ * select(out.z() > Real(0) && in.z() > Real(0), Real(Real(1) / pi<Real>), Real(0));
  }

  Density<SolidAngle, Real> pdf(const Vec3<Real>&, const Vec3<Real>& in) const { return directions_.pdf(in); }

  Bounce<Real> sample(const Vec3<Real>& out, const Vec2<Real>& u) const {
    const Vec3<Real> in = directions_.sample(u);
    return {in, Rgb<Real>(eval(out, in) * Real(in.z() / pdf(out, in).value())), pdf(out, in)};
  }

 private:
  Rgb<Real> albedo_;
  Directions<Real> directions_;
};

}  // namespace fairlight

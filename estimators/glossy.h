#pragma once

#include <concepts>
#include <stdexcept>

#include <fairlight/estimators/bsdf.h>
#include <fairlight/estimators/lobe.h>

namespace fairlight {

/// The paper's glossy surface: the modified Phong model, a lobe of exponent n about the mirror direction, at the
/// angle alpha from it. At normal incidence alpha is theta, and the reflectance is albedo (n + 2) int_0^1 z^n z dz
/// = albedo. Elsewhere it is less, as the surface cuts the lobe and the cosine is smaller: for n to infinity,
/// albedo cos(theta_out).
/// Formula  f = albedo (n + 2) / (2 pi) cos^n(alpha), without the cosine; 0 from 90 degrees on; sampled by Directions
/// Measure  f in 1/sr; the density is that of Directions, in solid angle
/// Domain   out and in with z > 0; f is 0 elsewhere: draws below the surface have their density, and weigh nothing.
///          n >= 0; albedo in [0,1] per channel
/// Random   u in [0,1)^2
/// Source   Lafortune and Willems 1994; the paper, 3.1
template <class Real, template <class> class Directions = PowerCosineLobe>
class Glossy {
 public:
  using Scalar = Real;
  static constexpr int dimensions = 2;

  /// Throws std::invalid_argument for an albedo or an exponent outside its domain.
  Glossy(const Rgb<Real>& albedo, Real exponent) : albedo_(albedo), exponent_(exponent) {
    for (int c = 0; c < 3; ++c) {
      if (!all(albedo[c] >= Real(0) && albedo[c] <= Real(1))) {
        throw std::invalid_argument("an albedo must be in [0,1] (a surface reflects a part of the light)");
      }
    }
    static_cast<void>(lobe({Real(0), Real(0), Real(1)}));
  }

  Rgb<Real> eval(const Vec3<Real>& out, const Vec3<Real>& in) const {
    const Real height = (exponent_ + Real(2)) / (exponent_ + Real(1));
    const Real f = height * lobe(out).pdf(in).value();
    return albedo_ * select(out.z() > Real(0) && in.z() > Real(0), f, Real(0));
  }

  Density<SolidAngle, Real> pdf(const Vec3<Real>& out, const Vec3<Real>& in) const {
    return directions(out).pdf(in);
  }

  /// A draw that does not exist, of density 0, has f = 0 as well.
  Bounce<Real> sample(const Vec3<Real>& out, const Vec2<Real>& u) const {
    const Vec3<Real> in = directions(out).sample(u);
    const Density<SolidAngle, Real> density = pdf(out, in);
    const Real divisor = select(density.value() > Real(0), density.value(), Real(1));
    return {in, Rgb<Real>(eval(out, in) * (in.z() / divisor)), density};
  }

 private:
  static Vec3<Real> mirrored(const Vec3<Real>& out) { return {-out.x(), -out.y(), out.z()}; }

  PowerCosineLobe<Real> lobe(const Vec3<Real>& out) const { return {mirrored(out), exponent_}; }

  Directions<Real> directions(const Vec3<Real>& out) const {
    if constexpr (std::constructible_from<Directions<Real>, Vec3<Real>, Real>) {
      return {mirrored(out), exponent_};
    } else {
      return {};
    }
  }

  Rgb<Real> albedo_;
  Real exponent_;
};

}  // namespace fairlight

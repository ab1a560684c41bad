#pragma once

#include <concepts>

#include <fairlight/estimators/bsdf.h>
#include <fairlight/estimators/gauss.h>
#include <fairlight/estimators/lobe.h>

namespace fairlight {

/// The paper's glossy surface, the modified Phong model: a lobe of exponent n about the mirror
/// direction, with the angle alpha from it.
/// Formula  f = albedo (n + 2) / (2 pi) cos^n(alpha), 0 for alpha >= 90 degrees, without the cosine
/// Measure  f in 1/sr; the density is that of Directions, which samples, in solid angle
/// Domain   z > 0, else f = 0 (draws below weigh 0); n in [0, 1e8]; albedo in [0,1] per channel
/// Random   u in [0,1)^2
/// Source   Lafortune and Willems 1994; the paper, 3.1
template <class Real, template <class> class Directions = PowerCosineLobe>
class Glossy {
  // It reflects its albedo at normal incidence, and less elsewhere, as the surface cuts the lobe
  // and the cosine is smaller. For n to infinity it reflects albedo cos(theta_out).
 public:
  using Scalar = Real;
  static constexpr int dimensions = 2;

  /// Throws std::invalid_argument for an albedo or an exponent outside its domain.
  Glossy(const Rgb<Real>& albedo, Real exponent) : albedo_(albedo), exponent_(exponent) {
    require_albedo(albedo);
    static_cast<void>(lobe({Real(0), Real(0), Real(1)}));
  }

  /// Accurate to a relative 1e-11, or to a few ulp of Real if that is more.
  // Let eta be the angle from the plane of the normal and the mirror direction, and phi the angle
  // within that plane from the mirror direction. The integrand is (n + 2) / (2 pi) cos^(n + 2)(eta)
  // times cos^n(phi) cos(phi - theta), and `in` is above the surface if phi > theta - 90 degrees.
  // The integral over eta is 1 divided by that of cos^(n + 1)(phi) over all phi, which is 2 A(90
  // degrees). The integral over phi, by parts, is z (A(90 degrees) + A(90 degrees - theta)) +
  // sin^(n + 2)(theta) / (n + 1).
  Rgb<Real> albedo(const Vec3<Real>& out) const {
    using std::atan2;
    using std::exp;
    using std::log;
    using std::log1p;
    using std::sqrt;
    const Mask<Real> above = out.z() > Real(0);
    const Real z = select(above, out.z(), Real(1));
    const Real square = select(above, Real(out.x() * out.x() + out.y() * out.y()), Real(0));
    const Mask<Real> low = z < Real(0.5);  // near the horizon the sine is inaccurate, and the cosine is not
    const Real log_square = select(low, Real(log1p(-z * z)), Real(log(square)));
    const Real cut = exp((exponent_ + Real(2)) / Real(2) * log_square) / (exponent_ + Real(1));
    const Real half = cosine_powers(Real(pi<Real> / Real(2)));
    const Real seen = z * (half + cosine_powers(Real(atan2(z, Real(sqrt(square)))))) + cut;
    return albedo_ * select(above, Real(seen / (Real(2) * half)), Real(0));
  }

  Rgb<Real> eval(const Vec3<Real>& out, const Vec3<Real>& in) const {
    const Real height = (exponent_ + Real(2)) / (exponent_ + Real(1));
    const Real f = height * lobe(out).pdf(in).value();
    return albedo_ * select(out.z() > Real(0) && in.z() > Real(0), f, Real(0));
  }

  Density<SolidAngle, Real> pdf(const Vec3<Real>& out, const Vec3<Real>& in) const {
    return directions(out).pdf(in);
  }

  /// A sample with density 0 does not exist; its f is 0 too.
  Bounce<Real> sample(const Vec3<Real>& out, const Vec2<Real>& u) const {
    const Vec3<Real> in = directions(out).sample(u);
    const Density<SolidAngle, Real> density = pdf(out, in);
    const Real divisor = select(density.value() > Real(0), density.value(), Real(1));
    return {in, Rgb<Real>(eval(out, in) * (in.z() / divisor)), density};
  }

 private:
  static Vec3<Real> mirrored(const Vec3<Real>& out) { return {-out.x(), -out.y(), out.z()}; }

  PowerCosineLobe<Real> lobe(const Vec3<Real>& out) const { return {mirrored(out), exponent_}; }

  /// A(angle), the integral of cos^(n + 1) from 0 to an angle of at most 90 degrees. It stops where
  /// a high power is negligible. The nodes are dense at the end, where a low power has a kink.
  Real cosine_powers(Real angle) const {
    using std::exp;
    using std::log1p;
    using std::min;
    using std::sin;
    using std::sqrt;
    const Real power = exponent_ + Real(1);
    const Real end = min(angle, Real(Real(7) / sqrt(power)));
    return Real(2) * end * integrate_unit<Real, 24>([&](Real x) {
             const Real sine = sin(end * x * (Real(2) - x) / Real(2));
             return Real((Real(1) - x) * exp(power * log1p(Real(-2) * sine * sine)));
           });
  }

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

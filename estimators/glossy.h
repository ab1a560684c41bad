#pragma once

#include <concepts>

#include <fairlight/estimators/bsdf.h>
#include <fairlight/estimators/gauss.h>
#include <fairlight/estimators/lobe.h>

namespace fairlight {

/// The paper's glossy surface: the modified Phong model, a lobe of exponent n about the mirror direction, at the
/// angle alpha from it. At normal incidence it reflects its albedo; elsewhere less, as the surface cuts the lobe and the
/// cosine is smaller: for n to infinity, albedo cos(theta_out).
/// Formula  f = albedo (n + 2) / (2 pi) cos^n(alpha), without the cosine; 0 from 90 degrees on; sampled by Directions
/// Measure  f in 1/sr; the density is that of Directions, in solid angle
/// Domain   out and in with z > 0; f is 0 elsewhere: draws below the surface have their density, and weigh nothing.
///          n in [0, 1e8]; albedo in [0,1] per channel
/// Random   u in [0,1)^2
/// Source   Lafortune and Willems 1994; the paper, 3.1
template <class Real, template <class> class Directions = PowerCosineLobe>
class Glossy {
 public:
  using Scalar = Real;
  static constexpr int dimensions = 2;

  /// Throws std::invalid_argument for an albedo or an exponent outside its domain.
  Glossy(const Rgb<Real>& albedo, Real exponent) : albedo_(albedo), exponent_(exponent) {
    require_albedo(albedo);
    static_cast<void>(lobe({Real(0), Real(0), Real(1)}));
  }

  /// To 1e-11 of it, or a few ulp of Real if that is more.
  ///
  /// In the angles eta from the plane of the normal and the mirror direction, and phi within it from the latter, the
  /// integrand is (n + 2) / (2 pi) cos^(n + 2)(eta) times cos^n(phi) cos(phi - theta), and in is above the surface where
  /// phi > theta - 90 degrees. So the integral over eta is one over that of all cos^(n + 1)(phi), 2 A(90 degrees), and
  /// that over phi, by parts, z (A(90 degrees) + A(90 degrees - theta)) + sin^(n + 2)(theta) / (n + 1).
  Rgb<Real> albedo(const Vec3<Real>& out) const {
    using std::atan2;
    using std::exp;
    using std::log;
    using std::log1p;
    using std::sqrt;
    const Mask<Real> above = out.z() > Real(0);
    const Real z = select(above, out.z(), Real(1));
    const Real square = select(above, Real(out.x() * out.x() + out.y() * out.y()), Real(0));
    const Mask<Real> low = z < Real(0.5);  // near the horizon the sine has lost its digits, and the cosine has not
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

  /// A(angle), the integral of cos^(n + 1) from 0 to an angle of up to 90 degrees: to where nothing is left of a high power,
  /// and with nodes that crowd at the end, where a low one has a kink.
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

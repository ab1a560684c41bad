#pragma once

#include <utility>

#include <fairlight/estimators/ggx_loss.h>
#include <fairlight/estimators/hemisphere.h>
#include <fairlight/estimators/rough_conductor.h>

namespace fairlight {

/// Rough metal without energy loss: a second, diffuse lobe adds the light that RoughConductor
/// loses.
/// Formula  f = f_1 + f_ms, f_ms = C (1 - E(out)) (1 - E(in)) / (pi (1 - Eavg)), C = Favg^2 Eavg /
///          (1 - Favg (1 - Eavg))
/// Measure  f in 1/sr; p = E(out) p_1 + (1 - E(out)) z_in / pi, in solid angle
/// Domain   z > 0, else f = p = 0; one roughness in [1e-4, 1]; Reflectance as in RoughConductor
/// Random   u in [0,1)^3; the third chooses the lobe
/// Source   Kulla and Conty 2017, "Revisiting physically based shading at Imageworks"
template <class Real, class Reflectance = ConstantReflectance<Real>, class Loss = GgxLoss>
class EnergyCompensatedConductor {
  // E is the albedo of f_1 for white facets, Eavg its cosine-weighted mean, and Favg the
  // cosine-weighted mean of F. C sums the light of all further reflections; C = 1 for white facets.
  // GgxLoss gives E to 1e-5.
 public:
  using Scalar = Real;
  static constexpr int dimensions = 3;

  /// All lanes have the same roughness, as the constructor computes its albedo.
  EnergyCompensatedConductor(double alpha, const Reflectance& reflectance)
      : single_(Ggx<Real>(rounded<Real>(alpha), rounded<Real>(alpha)), reflectance),
        loss_(alpha),
        mean_loss_(rounded<Real>(loss_.mean())) {
    const Rgb<Real> f = mean(reflectance);
    for (int c = 0; c < 3; ++c) {
      further_[c] = f[c] * f[c] * (Real(1) - mean_loss_) / ((Real(1) - f[c] * mean_loss_) * mean_loss_);
    }
  }

  /// The albedo of the first lobe plus further_ (1 - E(out)) (1 - Eavg), to 1e-5.
  Rgb<Real> albedo(const Vec3<Real>& out) const {
    const Mask<Real> above = out.z() > Real(0);
    const Real lost = loss_(select(above, out.z(), Real(1))) * mean_loss_;
    return single_.albedo(out) + further_ * select(above, lost, Real(0));
  }

  Rgb<Real> eval(const Vec3<Real>& out, const Vec3<Real>& in) const {
    const Mask<Real> both = out.z() > Real(0) && in.z() > Real(0);
    const Real lost = loss_(select(both, out.z(), Real(1))) * loss_(select(both, in.z(), Real(1)));
    return single_.eval(out, in) + further_ * select(both, Real(lost / pi<Real>), Real(0));
  }

  Density<SolidAngle, Real> pdf(const Vec3<Real>& out, const Vec3<Real>& in) const {
    const Mask<Real> both = out.z() > Real(0) && in.z() > Real(0);
    const Real lost = loss_(select(both, out.z(), Real(1)));
    const Real p = (Real(1) - lost) * single_.pdf(out, in).value() + lost * cosine_.pdf(in).value();
    return Density<SolidAngle, Real>(select(both, p, Real(0)));
  }

  Bounce<Real> sample(const Vec3<Real>& out, const Vec3<Real>& u) const {
    const Vec2<Real> v(u.x(), u.y());
    const Real lost = loss_(select(out.z() > Real(0), out.z(), Real(1)));
    const Vec3<Real> in = select(u.z() < lost, cosine_.sample(v), single_.sample(out, v).in);
    const Density<SolidAngle, Real> density = pdf(out, in);
    const Real p = select(density.value() > Real(0), density.value(), Real(1));
    return {in, Rgb<Real>(eval(out, in) * Real(in.z() / p)), density};
  }

 private:
  /// The cosine-weighted mean of F: twice the integral of F(z) z.
  static Rgb<Real> mean(const Reflectance& reflectance) {
    return integrate_unit<Real, 16>([&](Real z) { return Rgb<Real>(reflectance(z) * (Real(2) * z)); });
  }

  RoughConductor<Real, Reflectance> single_;
  Loss loss_;
  Real mean_loss_;  ///< 1 - Eavg
  CosineHemisphere<Real> cosine_;
  Rgb<Real> further_;  ///< C / (1 - Eavg)
};

}  // namespace fairlight

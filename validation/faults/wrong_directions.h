#pragma once

#include <fairlight/estimators/cone.h>
#include <fairlight/estimators/glossy.h>
#include <fairlight/estimators/hemisphere.h>
#include <fairlight/estimators/lobe.h>

/// Wrong variants of laws of directions and of what samples them, each a bug that a project
/// shipped.
namespace fairlight::faults {

/// Directions in a cone with a uniform polar angle: they crowd at the axis. The density is that of
/// uniform directions.
/// On record: the class of openmc #2041, appleseed #2851.
template <class Real>
class ThetaUniformCone : public UniformCone<Real> {
 public:
  using UniformCone<Real>::UniformCone;
  explicit ThetaUniformCone(const UniformCone<Real>& right) : UniformCone<Real>(right) {}
  static ThetaUniformCone of_sine_squared(Real s) {
    return ThetaUniformCone(UniformCone<Real>::of_sine_squared(s));
  }

  Vec3<Real> sample(const Vec2<Real>& u) const {
    using std::asin;
    using std::sin;
    using std::sqrt;
    const Real half_widest = asin(sqrt(this->solid_angle() / (Real(4) * pi<Real>)));
    const Real sine = sin(half_widest * u.x());
    return detail::direction_below_pole(Real(Real(2) * sine * sine), u.y());
  }
};

/// Computes the sine of a direction in the cone from its cosine, so that a narrow cone collapses to
/// its axis.
/// On record: pbrt-v3 #212.
template <class Real>
class CollapsedCone : public UniformCone<Real> {
 public:
  explicit CollapsedCone(const UniformCone<Real>& right) : UniformCone<Real>(right) {}
  static CollapsedCone of_sine_squared(Real s) { return CollapsedCone(UniformCone<Real>::of_sine_squared(s)); }

  Vec3<Real> sample(const Vec2<Real>& u) const {
    using std::sqrt;
    const Real z = UniformCone<Real>::sample(u).z();
    return detail::direction_at(z, Real(sqrt(Real(1) - z * z)), u.y());
  }
};

/// A lobe whose draws have the exponent n - 1: cos = (1-u)^(1/n), without the +1. The density has
/// n.
/// On record: the class of raytracing.github.io #145.
template <class Real>
class BluntLobe : public PowerCosineLobe<Real> {
 public:
  BluntLobe(const Vec3<Real>& axis, Real exponent)
      : PowerCosineLobe<Real>(axis, exponent), drawn_(axis, exponent - Real(1)) {}
  Vec3<Real> sample(const Vec2<Real>& u) const { return drawn_.sample(u); }

 private:
  PowerCosineLobe<Real> drawn_;
};

template <class Real>
using BluntGlossy = Glossy<Real, BluntLobe>;

/// A glossy surface that takes the magnitude of the cosine, so that it reflects directions below
/// it.
/// On record: the class of dspbr-pt #5 (support).
template <class Real>
struct LeakyGlossy : Glossy<Real> {
  using Glossy<Real>::Glossy;
  Bounce<Real> sample(const Vec3<Real>& out, const Vec2<Real>& u) const {
    using std::abs;
    Bounce<Real> bounce = Glossy<Real>::sample(out, u);
    bounce.in.z() = abs(bounce.in.z());
    bounce.weight = this->eval(out, bounce.in) * (bounce.in.z() / this->pdf(out, bounce.in).value());
    return bounce;
  }
};

/// The density for the cosine over a whole sphere: half as large.
/// On record: the class of raytracing.github.io #145.
template <class Real>
struct HalfCosineDensity : CosineHemisphere<Real> {
  Density<SolidAngle, Real> pdf(const Vec3<Real>& w) const {
    return Density<SolidAngle, Real>(CosineHemisphere<Real>::pdf(w).value() / Real(2));
  }
};

/// Projects points of the disk whose radius lacks the square root: directions crowd at the pole.
/// On record: the class of raytracing.github.io #145.
template <class Real>
struct CrowdedCosine : CosineHemisphere<Real> {
  Vec3<Real> sample(const Vec2<Real>& u) const {
    using std::sqrt;
    return detail::direction_at(Real(sqrt((Real(1) - u.x()) * (Real(1) + u.x()))), u.x(), u.y());
  }
};

/// Uniform directions with the density of cosine-weighted ones. Where f is constant every bounce
/// still has the albedo as its weight: the wrong density hides the wrong draws.
/// On record: raytracing.github.io #933.
template <class Real>
struct UniformCalledCosine : CosineHemisphere<Real> {
  Vec3<Real> sample(const Vec2<Real>& u) const {
    return UniformHemisphere<Real>().sample({Real(1) - u.x(), u.y()});
  }
};

/// Directions in one half of a cone, with the density of the whole. An integrand that is the same
/// in both halves hides it.
/// On record: the class of raytracing.github.io #933.
template <class Real>
class HalfCone : public UniformCone<Real> {
 public:
  using UniformCone<Real>::UniformCone;
  explicit HalfCone(const UniformCone<Real>& right) : UniformCone<Real>(right) {}
  static HalfCone of_sine_squared(Real s) { return HalfCone(UniformCone<Real>::of_sine_squared(s)); }
  Vec3<Real> sample(const Vec2<Real>& u) const { return UniformCone<Real>::sample({u.x(), u.y() / Real(2)}); }
};

/// Cosine-weighted directions with an exponent 1e-4 too large.
template <class Real>
struct HardlySteepCosine : CosineHemisphere<Real> {
  Vec3<Real> sample(const Vec2<Real>& u) const {
    using std::pow;
    using std::sqrt;
    const Real z = pow(Real(1) - u.x(), rounded<Real>(1 / 2.0001));
    return detail::direction_at(z, Real(sqrt((Real(1) - z) * (Real(1) + z))), u.y());
  }
};

}  // namespace fairlight::faults

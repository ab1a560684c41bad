#pragma once

#include <fairlight/estimators/pick_one.h>
#include <fairlight/estimators/roulette.h>
#include <fairlight/estimators/sphere_sampling.h>
#include <fairlight/estimators/uniform_sphere_area.h>

/// Wrong variants of components, each a bug that a project shipped. They replace the right ones
/// through the same template parameters, and are part of no library.
namespace fairlight::faults {

/// Points on a sphere with a uniform polar angle: they crowd at the poles. The density is that of
/// uniform points.
/// On record: Smerity/montelight-cpp.
template <class Real>
struct ThetaUniformSphere : UniformSphereArea<Real> {
  using UniformSphereArea<Real>::UniformSphereArea;
  Vec3<Real> sample(const Vec2<Real>& u) const {
    const Real theta = pi<Real> * u.x();
    const Real phi = Real(2) * pi<Real> * u.y();
    using std::cos;
    using std::sin;
    return {sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)};
  }
};

template <class Real>
using SphereByTheta = SphereByArea<Real, ThetaUniformSphere>;

/// Cosine-weighted directions with an exponent 2 % too large.
/// On record: the class of raytracing.github.io #145.
template <class Real>
struct SteepCosineHemisphere : CosineHemisphere<Real> {
  Vec3<Real> sample(const Vec2<Real>& u) const {
    using std::pow;
    using std::sqrt;
    const Real z = pow(Real(1) - u.x(), rounded<Real>(1 / 2.02));
    return detail::direction_at(z, Real(sqrt((Real(1) - z) * (Real(1) + z))), u.y());
  }
};

/// Does not divide survivors by their probability.
/// On record: openmc #3511, chunky #1018, Montelight.
struct UnpaidRoulette {
  template <class Real>
  static Survival<Real> play(Real q, Real u) {
    return {u < q, Real(1)};
  }
};

/// One luminaire instead of all, not multiplied by their number.
/// On record: the class of LuxCore #68.
struct OneUnweighted : UniformLightSampler {
  template <class Real, UniformSource<Real> Source, class Term>
  static auto sum(int n, Source& source, const Term& term) {
    return term(UniformChoice<Real>(n).sample(next_pair<Real>(source)).index, source);
  }
};

}  // namespace fairlight::faults

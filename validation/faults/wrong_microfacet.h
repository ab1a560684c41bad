#pragma once

#include <boost/math/quadrature/gauss.hpp>

#include <fairlight/estimators/energy_compensation.h>

/// Wrong microfacets, each a bug that a project shipped, or of the class of one. They replace the
/// right ones through the same template parameters, and are part of no library.
namespace fairlight::faults {

/// Takes the density of the normal for that of the direction: 1 / (4 out.m) is missing.
/// On record: the class of AdaPT #22.
template <class Real>
struct NoHalfVectorJacobian : GgxVisibleNormals<Real> {
  using GgxVisibleNormals<Real>::GgxVisibleNormals;
  Density<SolidAngle, Real> reflected_pdf(const Vec3<Real>& m) const { return this->pdf(m); }
};

/// The density max(0, out.m) D(m) / z_out, without masking.
/// On record: the class of three-gpu-pathtracer #847.
template <class Real>
class UnmaskedNormals : public GgxVisibleNormals<Real> {
 public:
  UnmaskedNormals(const Ggx<Real>& facets, const Vec3<Real>& out)
      : GgxVisibleNormals<Real>(facets, out), masking_(facets.masking(out)) {}
  Density<SolidAngle, Real> pdf(const Vec3<Real>& m) const { return unmasked(GgxVisibleNormals<Real>::pdf(m)); }
  Density<SolidAngle, Real> reflected_pdf(const Vec3<Real>& m) const {
    return unmasked(GgxVisibleNormals<Real>::reflected_pdf(m));
  }

 private:
  Density<SolidAngle, Real> unmasked(Density<SolidAngle, Real> p) const {
    return Density<SolidAngle, Real>(p.value() / masking_);
  }
  Real masking_;
};

/// Samples all facets by their area, with the density of the visible ones.
/// On record: the class of pbrt-v4 #215.
template <class Real>
class UnweightedNormals : public GgxVisibleNormals<Real> {
 public:
  UnweightedNormals(const Ggx<Real>& facets, const Vec3<Real>& out)
      : GgxVisibleNormals<Real>(facets, out), all_(facets, {Real(0), Real(0), Real(1)}) {}
  Vec3<Real> sample(const Vec2<Real>& u) const { return all_.sample(u); }

 private:
  GgxVisibleNormals<Real> all_;
};

/// Treats masking and shadowing as independent, G1 G1, in one of the places that use them.
/// On record: the class of mitsuba3 bcc10a142.
template <class Real>
struct IndependentShadowing : Ggx<Real> {
  using Ggx<Real>::Ggx;
  Real visibility(const Vec3<Real>& out, const Vec3<Real>& in) const {
    return Real(1) / (Real(4) * this->projected_area(out) * this->projected_area(in));
  }
};

/// Takes Fresnel's reflectance at the surface's normal where it samples, and at the facet in `eval`.
/// A constant reflectance hides it.
/// On record: none; two places that disagree about a cosine are the class of mitsuba3 #1011.
template <class Real, class Reflectance>
class FresnelAtTheNormal : public RoughConductor<Real, Reflectance> {
 public:
  FresnelAtTheNormal(const Ggx<Real>& facets, const Reflectance& reflectance)
      : RoughConductor<Real, Reflectance>(facets, reflectance),
        white_(facets, ConstantReflectance<Real>(Rgb<Real>::Constant(Real(1)))),
        reflectance_(reflectance) {}
  Bounce<Real> sample(const Vec3<Real>& out, const Vec2<Real>& u) const {
    Bounce<Real> bounce = white_.sample(out, u);
    bounce.weight *= reflectance_(out.z());
    return bounce;
  }

 private:
  RoughConductor<Real> white_;
  Reflectance reflectance_;
};

/// The mean loss without the cosine. It is too small, so the surface returns more energy than it
/// lost.
/// On record: the class of pbrt-v4's BSDF energy test.
struct PlainMeanLoss : GgxLoss {
  using GgxLoss::GgxLoss;
  double mean() const {
    return boost::math::quadrature::gauss<double, 30>::integrate([this](double z) { return (*this)(z); }, 0, 1);
  }
};

}  // namespace fairlight::faults

#pragma once

#include <algorithm>
#include <utility>

#include <fairlight/estimators/bsdf.h>
#include <fairlight/estimators/ggx_albedo.h>
#include <fairlight/estimators/ranges.h>
#include <fairlight/estimators/reflectance.h>

namespace fairlight {

/// Rough metal: single reflection by GGX facets.
/// Formula  f = D(h) G2(out, in) F(out.h) / (4 z_out z_in), h halfway between out and in; without
///          the cosine
/// Measure  f in 1/sr; p(in) = G1(out) D(h) / (4 z_out) in solid angle, by sampling visible normals
/// Domain   z >= 1e-27 in floats, 1e-290 in double, else f = p = 0; roughness in [1e-4, 1];
///          Reflectance is F, from the cosine at the facet to an Rgb
/// Random   u in [0,1)^2
/// Source   Walter et al. 2007; Heitz 2018
template <class Real, class Reflectance = ConstantReflectance<Real>, class Facets = Ggx<Real>,
          class Normals = GgxVisibleNormals<Real>>
class RoughConductor {
  // Light that facets reflect onto each other is lost: of white light up to 69 % at alpha = 1
  // (docs/estimators.md). EnergyCompensatedConductor adds it. Below z = 1e-27 in floats, 1e-290 in
  // double, f would be NaN. p integrates to the probability that a facet reflects upwards. A bounce
  // weighs F G2/G1 <= F.
 public:
  using Scalar = Real;
  static constexpr int dimensions = 2;

  RoughConductor(const Facets& facets, Reflectance reflectance)
      : facets_(facets), reflectance_(std::move(reflectance)) {}

  /// Accurate to 2e-6, by quadrature. Throws below the smallest height of ggx_albedo.
  Rgb<Real> albedo(const Vec3<Real>& out) const {
    const Mask<Real> exists = above(out);
    return select(exists, ggx_albedo(facets_, select(exists, out, up()), reflectance_), zero<Rgb<Real>>());
  }

  Rgb<Real> eval(const Vec3<Real>& out, const Vec3<Real>& in) const {
    const Mask<Real> both = above(out) && above(in);
    const Vec3<Real> o = select(both, out, up());
    const Vec3<Real> i = select(both, in, up());
    const auto [m, cosine] = halfway(o, i);
    const Rgb<Real> f = reflectance_(cosine) * Real(facets_.distribution(m) * facets_.visibility(o, i));
    return select(both, f, zero<Rgb<Real>>());
  }

  Density<SolidAngle, Real> pdf(const Vec3<Real>& out, const Vec3<Real>& in) const {
    const Mask<Real> both = above(out) && above(in);
    const Vec3<Real> o = select(both, out, up());
    const Real p = Normals(facets_, o).reflected_pdf(halfway(o, select(both, in, up())).normal).value();
    return Density<SolidAngle, Real>(select(both, p, Real(0)));
  }

  /// Evaluates the density at the facet, not at `in`: a roughness of 1e-4 would magnify the
  /// rounding of `in`.
  Bounce<Real> sample(const Vec3<Real>& out, const Vec2<Real>& u) const {
    const Vec3<Real> o = select(above(out), out, up());
    const Normals normals(facets_, o);
    const Vec3<Real> m = normals.sample(u);
    const Vec3<Real> in = Real(2) * o.dot(m) * m - o;
    const Mask<Real> exists = above(out) && above(in);
    const Vec3<Real> i = select(exists, in, up());
    const Real seen = Real(4) * facets_.projected_area(o) * facets_.visibility(o, i) * i.z();  // G2/G1
    const Real p = normals.reflected_pdf(m).value();
    return {in, select(exists, Rgb<Real>(reflectance_(o.dot(m)) * seen), zero<Rgb<Real>>()),
            Density<SolidAngle, Real>(select(exists, p, Real(0)))};
  }

 private:
  static constexpr Lane<Real> lowest = in_floats<Real> ? Lane<Real>(1e-27) : Lane<Real>(1e-290);

  // The facet that reflects one direction to the other, and its cosine with both, which is half the
  // length of their sum. If both graze from opposite sides, the squares of the sum underflow, so
  // the sum is first divided by its largest component.
  struct Facet {
    Vec3<Real> normal;
    Real cosine;
  };
  static Facet halfway(const Vec3<Real>& out, const Vec3<Real>& in) {
    using std::abs;
    using std::max;
    const Vec3<Real> sum = out + in;
    const Real scale = max(Real(max(Real(abs(sum.x())), Real(abs(sum.y())))), sum.z());
    const Vec3<Real> part = sum * Real(Real(1) / scale);
    const Real length = part.norm();
    return {part / length, scale * length / Real(2)};
  }

  static Mask<Real> above(const Vec3<Real>& w) { return w.z() >= Real(lowest); }
  static Vec3<Real> up() { return {Real(0), Real(0), Real(1)}; }

  Facets facets_;
  Reflectance reflectance_;
};

}  // namespace fairlight

#pragma once

#include <fairlight/estimators/importance.h>
#include <fairlight/estimators/rough_conductor.h>
#include <fairlight/validation/checks/law_claims.h>
#include <fairlight/validation/claims/ggx_albedo.h>

namespace fairlight {

/// A GGX surface, and the direction that it is seen from: the height z > 0, at a fixed azimuth.
struct GgxView {
  double alpha_x, alpha_y, z;

  Eigen::Vector3d out() const {
    const double sine = std::sqrt((1 - z) * (1 + z));
    return {0.8 * sine, 0.6 * sine, z};
  }
  template <template <class> class Facets, class Real>
  Facets<Real> facets() const {
    return {rounded<Real>(alpha_x), rounded<Real>(alpha_y)};
  }
  double albedo() const { return GgxAlbedo{alpha_x, alpha_y}(out()); }
};

/// Visible normals follow their density, on the lune above the surface that faces `out`, where the
/// density is smooth.
template <template <class> class Normals = GgxVisibleNormals>
auto visible_normals_law(const std::string& name, const GgxView& view) {
  return LawEstimand{name, "GgxVisibleNormals", "Heitz 2018; Dupuy and Benyoub 2023",
                     [=]<class Real>(std::type_identity<Real>) {
                       return Normals<Real>(view.facets<Ggx, Real>(), rounded_vector<Real>(view.out()));
                     },
                     LuneDomain{view.out(), Eigen::Vector3d::UnitZ()}};
}

/// The projected area of the facets as seen from `out`: the integral of max(0, out.m) D(m) is z
/// (1 + Lambda), with masked and unmasked facets together.
/// Bound    D <= 1 / (pi ax ay), as no roughness is above 1, over the density 1 / (2 pi) of uniform
///          directions
template <template <class> class Facets = Ggx>
auto facet_area(const std::string& name, const GgxView& view) {
  const auto draw = [=]<class Real>(std::type_identity<Real>, auto& source) {
    const Facets<Real> facets = view.facets<Facets, Real>();
    const Vec3<Real> out = rounded_vector<Real>(view.out());
    return Importance(UniformHemisphere<Real>{},
                      [=](const Vec3<Real>& m) {
                        const Real facing = out.dot(m);
                        return Real(select(facing > Real(0), facing, Real(0)) * facets.distribution(m));
                      })
        .estimate(source);
  };
  const double area = view.z * (1 + GgxAlbedo{view.alpha_x, view.alpha_y}.lambda(view.out()));
  return estimand(name, {"Ggx", "UniformHemisphere"},
                  "the facets that face a direction have the area cos(theta) (1 + Lambda), seen from there",
                  "Heitz 2014", {{area, 0, 2 / (view.alpha_x * view.alpha_y) * (1 + 1e-12)}}, draw);
}

/// A conductor of white facets. A fault can replace its parts.
template <class Real, template <class> class Facets, template <class> class Normals>
auto white_conductor(const GgxView& view) {
  using Surface = RoughConductor<Real, ConstantReflectance<Real>, Facets<Real>, Normals<Real>>;
  return Surface(view.facets<Facets, Real>(), ConstantReflectance<Real>(Rgb<Real>::Constant(Real(1))));
}

/// The mean weight of a bounce is the albedo.
/// Bound    G2/G1 <= 1, and a little more, since the albedo plus its margin may exceed 1
template <template <class> class Facets = Ggx, template <class> class Normals = GgxVisibleNormals>
auto conductor_weight(const std::string& name, const GgxView& view) {
  const auto draw = [=]<class Real>(std::type_identity<Real>, auto& source) {
    const auto surface = white_conductor<Real, Facets, Normals>(view);
    return Real(surface.sample(rounded_vector<Real>(view.out()), next_pair<Real>(source)).weight[0]);
  };
  return estimand(name, {"RoughConductor", "Ggx", "GgxVisibleNormals", "ConstantReflectance"},
                  "the weight of a bounce off white facets has the albedo as its mean",
                  "quadrature over the slopes; Walter et al. 2007", {{view.albedo(), 0, 1.01}}, draw);
}

/// The same from `eval` and the density of the bounce; 0 if there is none.
template <template <class> class Facets = Ggx, template <class> class Normals = GgxVisibleNormals>
auto conductor_density(const std::string& name, const GgxView& view) {
  const auto draw = [=]<class Real>(std::type_identity<Real>, auto& source) {
    const auto surface = white_conductor<Real, Facets, Normals>(view);
    const Vec3<Real> out = rounded_vector<Real>(view.out());
    const Bounce<Real> bounce = surface.sample(out, next_pair<Real>(source));
    const Real p = bounce.density.value();
    return Real(surface.eval(out, bounce.in)[0] * bounce.in.z() / select(p > Real(0), p, Real(1)));
  };
  return estimand(name, {"RoughConductor", "Ggx", "GgxVisibleNormals", "ConstantReflectance"},
                  "f cos / p of the bounces off white facets has the albedo as its mean",
                  "quadrature over the slopes; Walter et al. 2007", {{view.albedo(), 0, 1.01}}, draw);
}

/// The same from uniform directions.
/// Bound    D <= 1 / (pi ax ay), and z_in / (2 (s_out z_in + s_in z_out)) <= 1 / (2 s_out),
///          s_out >= z (1 + 2 Lambda)
template <template <class> class Facets = Ggx>
auto conductor_uniform(const std::string& name, const GgxView& view) {
  const auto draw = [=]<class Real>(std::type_identity<Real>, auto& source) {
    const auto surface = white_conductor<Real, Facets, GgxVisibleNormals>(view);
    const Vec3<Real> out = rounded_vector<Real>(view.out());
    return Importance(UniformHemisphere<Real>{},
                      [=](const Vec3<Real>& in) { return Real(surface.eval(out, in)[0] * in.z()); })
        .estimate(source);
  };
  const double stretched = view.z * (1 + 2 * GgxAlbedo{view.alpha_x, view.alpha_y}.lambda(view.out()));
  return estimand(name, {"RoughConductor", "UniformHemisphere"},
                  "the integral of f cos over uniform directions is the albedo of white facets",
                  "quadrature over the slopes; Walter et al. 2007",
                  {{view.albedo(), 0, (1 + 1e-12) / (view.alpha_x * view.alpha_y * stretched)}}, draw);
}

}  // namespace fairlight

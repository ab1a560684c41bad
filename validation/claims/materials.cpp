#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/claims/integrals.h>
#include <fairlight/validation/claims/mixtures.h>
#include <fairlight/validation/claims/reflectances.h>
#include <fairlight/validation/claims/surface_identities.h>

namespace fairlight {
namespace {

template <class Real>
using Glass = Dielectric<Real>;
template <class Real>
using ImportanceGlass = Dielectric<Real, Transport::importance>;

constexpr double degree = std::numbers::pi / 180;

void add_smooth_claims(std::vector<Claim>& claims) {
  add_constant(claims, constant_weight("mirror.weight", {"Mirror"}, "elementary", 60 * degree, 0.75,
                                       []<class Real>(std::type_identity<Real>) {
                                         return Mirror<Real>(detail::grey<Real>(0.75));
                                       }));
  const auto copper = []<class Real>(std::type_identity<Real>) { return Copper().surface<Real>(); };
  add_constant(claims, constant_weight("conductor.weight", {"Conductor", "fresnel_conductor"},
                                       "Born and Wolf, 14.2, in complex amplitudes", 60 * degree,
                                       Copper().reflectance(0, 60 * degree), copper));
  add_mean(claims, conductor_diffuse("conductor.diffuse"));
}

void add_reflectances(std::vector<Claim>& claims) {
  for (const CosineRange& range : cosine_ranges) {
    add_mean_over(claims, insulator_ranges(),
                  [range](const std::vector<double>& values) { return insulator_outside(range, values); });
    add_mean_over(claims, metal_index_ranges(),
                  [range](const std::vector<double>& values) { return metal_reflectance(range, values); });
    add_mean_over(claims, schlick_ranges(),
                  [range](const std::vector<double>& values) { return schlick_reflectance(range, values); });
  }
  for (const bool refracted : {false, true}) {
    add_mean_over(claims, insulator_ranges(), [refracted](const std::vector<double>& values) {
      return insulator_inside(refracted ? "fresnel.dielectric.inside.refracted" : "fresnel.dielectric.inside",
                              refracted, values);
    });
  }
}

void add_glass_claims(std::vector<Claim>& claims) {
  add_mean(claims, fresnel_diffuse("fresnel.diffuse"));
  add_mean(claims, glass_albedo<Glass>("dielectric.outside.albedo", {0, 60, 80}, true));
  add_mean(claims, glass_albedo<Glass>("dielectric.inside.albedo", {0, 30, 60}, false));
  add_mean(claims, glass_diffuse<Glass>("dielectric.outside.diffuse", true));
  add_mean(claims, glass_diffuse<Glass>("dielectric.inside.diffuse", false));
  add_constant(claims, glass_energy<Glass>());
  add_constant(claims, constant_weight("dielectric.importance.weight", {"Dielectric"}, "conservation of energy", 1,
                                       1, []<class Real>(std::type_identity<Real>) {
                                         return ImportanceGlass<Real>(rounded<Real>(detail::glass_index));
                                       }));
}

template <class Surface>
void add_identities(std::vector<Claim>& claims) {
  add_constant(claims, bounce_identity<Surface>());
  add_constant(claims, reciprocity<Surface>());
}

void add_mixture_claims(std::vector<Claim>& claims) {
  add_mean(claims, two_lambertians<Mixture>("mixture.lambertians.albedo"));
  add_mean(claims, mirror_and_lambertian<Mixture>("mixture.mirror.albedo"));
  add_constant(claims,
               constant_weight("mixture.proportional.weight", {"Mixture", "Mirror", "Lambertian"},
                               "f cos / p = the sum of w rho, where q is proportional to w rho", 1, 0.625,
                               []<class Real>(std::type_identity<Real>) { return proportional_mixture<Real>(); }));
}

}  // namespace

void add_material_claims(std::vector<Claim>& claims) {
  add_mean(claims, lambertian_albedo<UniformHemisphere>("lambertian.uniform.albedo", "UniformHemisphere"));
  add_constant(
      claims,
      constant_weight(
          "lambertian.cosine.weight", {"Lambertian", "CosineHemisphere"}, "f cos / p = albedo", 0, 0.75,
          []<class Real>(std::type_identity<Real>) { return Lambertian<Real>(detail::grey<Real>(0.75)); }, 4));
  add_smooth_claims(claims);
  add_reflectances(claims);
  add_glass_claims(claims);
  add_mixture_claims(claims);
  add_identities<AnyLambertian>(claims);
  add_identities<AnyGlossy>(claims);
  add_identities<AnyRoughMetal<>>(claims);
  add_identities<AnyMixture>(claims);
}

}  // namespace fairlight

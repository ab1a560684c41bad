#include <fairlight/validation/checks/law_claims.h>
#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/claims/directions.h>
#include <fairlight/validation/claims/glossy.h>
#include <fairlight/validation/claims/integrals.h>

namespace fairlight {

namespace {

void add_hemispheres(std::vector<Claim>& claims) {
  constexpr double tau = 2 * std::numbers::pi;
  add_law(claims, LawEstimand{"hemisphere.uniform", "UniformHemisphere", "PBR 4ed, A.5.2",
                              component<UniformHemisphere>(), HemisphereDomain{}});
  add_law(claims, cosine_law<CosineHemisphere>());
  add_mean(claims,
           hemisphere_integral<UniformHemisphere>("importance.uniform.cosine", "UniformHemisphere", 1, tau));
  add_mean(claims, hemisphere_integral<CosineHemisphere>("importance.cosine.cosine_squared", "CosineHemisphere", 2,
                                                         tau / 2));
}

void add_cones_and_lobes(std::vector<Claim>& claims) {
  add_law(claims, LawEstimand{"sphere.uniform", "UniformSphere", "Archimedes", component<UniformSphere>(),
                              SphereDomain{1}});
  add_mean(claims, sphere_integral<UniformSphere>());
  add_law(claims, cone_law<UniformCone>());
  add_mean(claims, cone_integral<UniformCone>("importance.cone", 0.75));
  add_mean(claims, cone_integral<UniformCone>("importance.cone.narrow", 1e-16));
  add_law(claims, lobe_law<PowerCosineLobe>("lobe.power", 20));
  claims.push_back(density_claim(lobe_law<PowerCosineLobe>("lobe.power.sharp", 1e6)));
  add_mean(claims, lobe_integral<PowerCosineLobe>("importance.lobe", 5));
  add_mean(claims, lobe_integral<PowerCosineLobe>("importance.lobe.sharp", 1e6));
}

void add_glossy(std::vector<Claim>& claims) {
  add_mean(claims, glossy_normal<LobeGlossy>());
  add_mean(claims, glossy_oblique<LobeGlossy>());
  add_mean(claims, glossy_albedo<CosineGlossy>("glossy.oblique.cosine", 2, std::numbers::pi / 6, 2));
}

}  // namespace

void add_direction_claims(std::vector<Claim>& claims) {
  add_hemispheres(claims);
  add_cones_and_lobes(claims);
  add_glossy(claims);
}

}  // namespace fairlight

#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/claims/coloured_metals.h>
#include <fairlight/validation/claims/energy_compensation.h>

namespace fairlight {
namespace {

void add_visible_normals(std::vector<Claim>& claims) {
  add_law(claims, visible_normals_law("ggx.isotropic", {0.3, 0.3, 0.8}));
  add_law(claims, visible_normals_law("ggx.anisotropic", {0.6, 0.25, 0.7}));
  add_mean(claims, facet_area("ggx.facet_area", {0.8, 1, 0.7}));
}

void add_rough_conductor(std::vector<Claim>& claims) {
  add_mean(claims, conductor_weight("rough_conductor.albedo.smooth", {1e-4, 1e-4, 0.7}));
  add_mean(claims, conductor_weight("rough_conductor.albedo.smooth_grazing", {1e-4, 1e-4, 2e-4}));
  add_mean(claims, conductor_weight("rough_conductor.albedo.smoother_grazing", {0.01, 0.01, 0.02}));
  add_mean(claims, conductor_weight("rough_conductor.albedo.normal", {0.1, 0.1, 1}));
  add_mean(claims, conductor_weight("rough_conductor.albedo.grazing", {0.3, 0.3, 0.05}));
  add_mean(claims, conductor_weight("rough_conductor.albedo.rough", {0.6, 0.6, 0.7}));
  add_mean(claims, conductor_weight("rough_conductor.albedo.brushed", {0.6, 0.01, 0.4}));
  add_mean(claims, conductor_density("rough_conductor.density", {0.3, 0.3, 0.6}));
  add_mean(claims, conductor_density("rough_conductor.density.brushed", {0.5, 0.2, 0.7}));
  add_mean(claims, conductor_uniform("rough_conductor.uniform", {0.6, 0.6, 0.8}));
}

template <class Real>
void add_coloured_metals(std::vector<Claim>& claims) {
  for (const Claim& claim : smooth_metal_claims<Real>()) claims.push_back(claim);
  for (const Claim& claim : rough_metal_claims<Real>()) claims.push_back(claim);
}

// The bounds are the larger of 1 / E(out) and the largest loss over the mean loss, rounded up.
void add_energy_compensation(std::vector<Claim>& claims) {
  add_mean(claims, metal_furnace("energy_compensation.furnace.smooth", 0.03, 0.5, 32));
  add_mean(claims, metal_furnace("energy_compensation.furnace.normal", 0.1, 1, 5));
  add_mean(claims, metal_furnace("energy_compensation.furnace.grazing", 0.3, 0.05, 1.5));
  add_mean(claims, metal_furnace("energy_compensation.furnace.rough", 0.5, 0.7, 1.6));
  add_mean(claims, grey_metal("energy_compensation.grey"));
  add_mean(claims, metal_uniform("energy_compensation.uniform"));
}

}  // namespace

void add_microfacet_claims(std::vector<Claim>& claims) {
  add_visible_normals(claims);
  add_rough_conductor(claims);
  add_coloured_metals<double>(claims);
  add_coloured_metals<Packet>(claims);
  add_energy_compensation(claims);
}

}  // namespace fairlight

#include <fairlight/validation/claims/coloured_metals.h>
#include <fairlight/validation/claims/energy_compensation.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_microfacet.h>

namespace fairlight {
namespace {

template <class Draw>
void add(Fault& fault, const Estimand<Draw>& experiment) {
  fault.claims.push_back(mean_claim(experiment));
  fault.claims.push_back(mean_claim<Packet>(experiment));
}

Fault no_jacobian() {
  Fault fault{"ggx-no-half-vector-jacobian", "measure", "AdaPT #22", {}};
  add(fault, conductor_density<Ggx, faults::NoHalfVectorJacobian>("rough_conductor.density", {0.3, 0.3, 0.6}));
  return fault;
}

Fault unmasked() {
  const auto law = visible_normals_law<faults::UnmaskedNormals>("ggx.isotropic", {0.3, 0.3, 0.8});
  Fault fault{"ggx-density-without-masking", "sample against pdf", "three-gpu-pathtracer #847", {law_claim(law)}};
  add(fault, conductor_density<Ggx, faults::UnmaskedNormals>("rough_conductor.density", {0.3, 0.3, 0.6}));
  return fault;
}

Fault unweighted() {
  const auto law = visible_normals_law<faults::UnweightedNormals>("ggx.anisotropic", {0.6, 0.25, 0.7});
  Fault fault{"ggx-normals-not-visible", "sample against pdf", "pbrt-v4 #215", {law_claim(law)}};
  add(fault, conductor_weight<Ggx, faults::UnweightedNormals>("rough_conductor.albedo.grazing", {0.3, 0.3, 0.05}));
  return fault;
}

Fault independent_shadowing() {
  Fault fault{"ggx-shadowing-independent", "weight", "mitsuba3 bcc10a142", {}};
  const GgxView smooth{1e-4, 1e-4, 2e-4}, rough{0.6, 0.6, 0.7};
  fault.claims = {
      mean_claim<Packet>(
          conductor_weight<faults::IndependentShadowing>("rough_conductor.albedo.smooth_grazing", smooth)),
      mean_claim<Packet>(conductor_weight<faults::IndependentShadowing>("rough_conductor.albedo.rough", rough))};
  return fault;
}

Fault fresnel_at_the_normal() {
  Fault fault{"fresnel-at-the-normal", "sample against pdf", "none: the cosine at another normal",
              rough_metal_claims<double, faults::FresnelAtTheNormal>()};
  const auto packets = rough_metal_claims<Packet, faults::FresnelAtTheNormal>();
  fault.claims.insert(fault.claims.end(), packets.begin(), packets.end());
  return fault;
}

Fault plain_mean_loss() {
  Fault fault{"energy-mean-without-cosine", "energy", "pbrt-v4 BSDF energy test", {}};
  add(fault, metal_furnace<faults::PlainMeanLoss>("energy_compensation.furnace.rough", 0.5, 0.7, 1.6));
  add(fault, grey_metal<faults::PlainMeanLoss>("energy_compensation.grey"));
  return fault;
}

}  // namespace

std::vector<Fault> microfacet_faults() {
  return {no_jacobian(),           unmasked(),       unweighted(), independent_shadowing(),
          fresnel_at_the_normal(), plain_mean_loss()};
}

}  // namespace fairlight

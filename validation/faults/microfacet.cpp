#include <fairlight/validation/claims/coloured_metals.h>
#include <fairlight/validation/claims/energy_compensation.h>
#include <fairlight/validation/claims/surface_identities.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_microfacet.h>

namespace fairlight {
namespace {

// The row of a law, and those of an estimand.
std::vector<Claim> law_and_mean(const auto& law, const auto& estimand) {
  std::vector<Claim> claims{law_claim(law)};
  add_independent_mean(claims, estimand);
  return claims;
}

template <template <class> class Normals>
auto density() {
  return conductor_density<Ggx, Normals>("rough_conductor.density", {0.3, 0.3, 0.6});
}

Fault fresnel_at_the_normal() {
  Fault fault{"fresnel-at-the-normal", "sample against pdf", "none: the cosine at another normal",
              rough_metal_claims<double, faults::FresnelAtTheNormal>()};
  const auto packets = rough_metal_claims<Packet, faults::FresnelAtTheNormal>();
  fault.claims.insert(fault.claims.end(), packets.begin(), packets.end());
  add_constant(fault.claims, bounce_identity<AnyRoughMetal<faults::FresnelAtTheNormal>>());
  return fault;
}

}  // namespace

std::vector<Fault> microfacet_faults() {
  using faults::IndependentShadowing, faults::PlainMeanLoss;
  const GgxView grazing{0.3, 0.3, 0.05}, smooth{1e-4, 1e-4, 2e-4}, rough{0.6, 0.6, 0.7};
  return {
      {"ggx-no-half-vector-jacobian", "measure", "AdaPT #22", both(density<faults::NoHalfVectorJacobian>())},
      {"ggx-density-without-masking", "sample against pdf", "three-gpu-pathtracer #847",
       law_and_mean(visible_normals_law<faults::UnmaskedNormals>("ggx.isotropic", {0.3, 0.3, 0.8}),
                    density<faults::UnmaskedNormals>())},
      {"ggx-normals-not-visible", "sample against pdf", "pbrt-v4 #215",
       law_and_mean(visible_normals_law<faults::UnweightedNormals>("ggx.anisotropic", {0.6, 0.25, 0.7}),
                    conductor_weight<Ggx, faults::UnweightedNormals>("rough_conductor.albedo.grazing", grazing))},
      {"ggx-shadowing-independent",
       "weight",
       "mitsuba3 bcc10a142",
       {mean_claim<Packet>(conductor_weight<IndependentShadowing>("rough_conductor.albedo.smooth_grazing", smooth)),
        mean_claim<Packet>(conductor_weight<IndependentShadowing>("rough_conductor.albedo.rough", rough))}},
      fresnel_at_the_normal(),
      {"energy-mean-without-cosine", "energy", "pbrt-v4 BSDF energy test",
       both(metal_furnace<PlainMeanLoss>("energy_compensation.furnace.rough", 0.5, 0.7, 1.6),
            grey_metal<PlainMeanLoss>("energy_compensation.grey"))}};
}

}  // namespace fairlight

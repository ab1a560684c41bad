#include <fairlight/validation/analytic/mixtures.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_materials.h>

namespace fairlight {
namespace {

template <template <class> class Glass>
std::vector<Claim> inside_glass() {
  std::vector<Claim> claims{glass_energy<double, Glass>("dielectric.energy"),
                            glass_energy<Packet, Glass>("dielectric.energy")};
  add_mean(claims, glass_albedo<Glass>("dielectric.inside.albedo", {0, 30, 60}, false));
  add_mean(claims, glass_diffuse<Glass>("dielectric.inside.diffuse", false));
  return claims;
}

Fault unscaled_refraction() {
  std::vector<Claim> claims = inside_glass<faults::UnscaledDielectric>();
  add_mean(claims, glass_albedo<faults::UnscaledDielectric>("dielectric.outside.albedo", {0, 60, 80}, true));
  add_mean(claims, glass_diffuse<faults::UnscaledDielectric>("dielectric.outside.diffuse", true));
  return {"refraction-unscaled", "weight", "caramel #36", claims};
}

Fault leaky_glass() {
  return {"total-reflection-missed", "energy", "yocto-gl #452; ChameleonRT #3",
          inside_glass<faults::LeakyDielectric>()};
}

Fault own_density() {
  std::vector<Claim> claims;
  add_mean(claims, two_lambertians<faults::OwnDensityMixture>("mixture.lambertians.albedo"));
  return {"mixture-own-density", "sample against pdf", "OpenShadingLanguage #2054", claims};
}

Fault unpaid_lobe() {
  std::vector<Claim> claims;
  add_mean(claims, mirror_and_lambertian<faults::UnpaidMixture>("mixture.mirror.albedo"));
  return {"mixture-lobe-unpaid", "weight", "mitsuba3 bcc10a142", claims};
}

}  // namespace

std::vector<Fault> material_faults() {
  return {unscaled_refraction(), leaky_glass(), own_density(), unpaid_lobe()};
}

}  // namespace fairlight

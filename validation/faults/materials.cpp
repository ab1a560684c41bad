#include <fairlight/validation/claims/mixtures.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_materials.h>

namespace fairlight {
namespace {

template <template <class> class Glass>
std::vector<Claim> inside_glass() {
  return {glass_energy<double, Glass>("dielectric.energy"),
          mean_claim(glass_albedo<Glass>("dielectric.inside.albedo", {0, 30, 60}, false)),
          mean_claim<Packet>(glass_diffuse<Glass>("dielectric.inside.diffuse", false))};
}

Fault unscaled_refraction() {
  return {"refraction-unscaled", "weight", "caramel #36", inside_glass<faults::UnscaledDielectric>()};
}

Fault leaky_glass() {
  return {"total-reflection-missed", "energy", "yocto-gl #452; ChameleonRT #3",
          inside_glass<faults::LeakyDielectric>()};
}

// The rows of an estimand, in double and in packets.
template <class Estimand>
std::vector<Claim> both(const Estimand& wrong) {
  return {mean_claim<double>(wrong), mean_claim<Packet>(wrong)};
}

Fault own_density() {
  return {"mixture-own-density", "sample against pdf", "OpenShadingLanguage #2054",
          both(two_lambertians<faults::OwnDensityMixture>("mixture.lambertians.albedo"))};
}

Fault unpaid_lobe() {
  return {"mixture-lobe-unpaid", "weight", "mitsuba3 bcc10a142",
          both(mirror_and_lambertian<faults::UnpaidMixture>("mixture.mirror.albedo"))};
}

Fault number_reused() {
  return {"mixture-number-reused", "reused number", "pbrt-v4 795c619b",
          both(two_lambertians<faults::NumberReusedWrongly>("mixture.lambertians.albedo"))};
}

Fault cosine_twice() {
  return {"cosine-twice", "weight", "mitsuba3 #1011",
          both(mirror_and_lambertian<faults::CosineTwice>("mixture.mirror.albedo"))};
}

}  // namespace

std::vector<Fault> material_faults() {
  return {unscaled_refraction(), leaky_glass(), own_density(), unpaid_lobe(), number_reused(), cosine_twice()};
}

}  // namespace fairlight

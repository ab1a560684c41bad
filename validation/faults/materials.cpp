#include <fairlight/validation/claims/mixtures.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_materials.h>

namespace fairlight {
namespace {

template <template <class> class Glass>
std::vector<Claim> inside_glass() {
  return {constant_claim<double>(glass_energy<Glass>()),
          mean_claim(glass_albedo<Glass>("dielectric.inside.albedo", {0, 30, 60}, false)),
          mean_claim<Packet>(glass_diffuse<Glass>("dielectric.inside.diffuse", false))};
}

template <template <class, class> class Mix>
std::vector<Claim> lambertians() {
  return both(two_lambertians<Mix>("mixture.lambertians.albedo"));
}
template <template <class, class> class Mix>
std::vector<Claim> mirror() {
  return both(mirror_and_lambertian<Mix>("mixture.mirror.albedo"));
}

}  // namespace

std::vector<Fault> material_faults() {
  return {
      {"refraction-unscaled", "weight", "caramel #36", inside_glass<faults::UnscaledDielectric>()},
      {"total-reflection-missed", "energy", "yocto-gl #452; ChameleonRT #3",
       inside_glass<faults::LeakyDielectric>()},
      {"mixture-own-density", "sample against pdf", "OpenShadingLanguage #2054",
       lambertians<faults::OwnDensityMixture>()},
      {"mixture-lobe-unpaid", "weight", "mitsuba3 bcc10a142", mirror<faults::UnpaidMixture>()},
      {"mixture-number-reused", "reused number", "pbrt-v4 795c619b", lambertians<faults::NumberReusedWrongly>()},
      {"cosine-twice", "weight", "mitsuba3 #1011", mirror<faults::CosineTwice>()}};
}

}  // namespace fairlight

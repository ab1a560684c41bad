#include <fairlight/validation/claims/directions.h>
#include <fairlight/validation/claims/glossy.h>
#include <fairlight/validation/claims/integrals.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_directions.h>

namespace fairlight {
namespace {

template <template <class> class Cone>
auto cone() {
  return cone_integral<Cone>("importance.cone", 0.75);
}

}  // namespace

std::vector<Fault> direction_faults() {
  const auto hardly_steep =
      hemisphere_integral<faults::HardlySteepCosine>("importance.cosine.cosine_squared", "", 2, std::numbers::pi);
  return {
      {"cone-theta-uniform",
       "cone sampler",
       "openmc #2041; appleseed #2851",
       {law_moments_claim(cone_law<faults::ThetaUniformCone>()),
        mean_claim<Packet>(cone<faults::ThetaUniformCone>())}},
      {"cone-collapsed", "cancellation", "pbrt-v3 #212",
       both(cone_integral<faults::CollapsedCone>("importance.cone.narrow", 1e-16))},
      {"lobe-exponent",
       "lobe sampler",
       "raytracing.github.io #145",
       {mean_claim(lobe_integral<faults::BluntLobe>("importance.lobe", 5)),
        mean_claim<Packet>(glossy_normal<faults::BluntGlossy>())}},
      {"glossy-below-surface",
       "support",
       "dspbr-pt #5",
       {mean_claim<Packet>(glossy_oblique<faults::LeakyGlossy>())}},
      {"cosine-density-halved",
       "cosine sampler",
       "raytracing.github.io #145",
       {law_claim(cosine_law<faults::HalfCosineDensity>())}},
      {"cosine-without-root",
       "cosine sampler",
       "raytracing.github.io #145",
       {law_moments_claim(cosine_law<faults::CrowdedCosine>())}},
      // The integral hides this fault: the integrand does not depend on the azimuth.
      {"cone-half-turn",
       "two wrongs",
       "the class of raytracing.github.io #933",
       {law_moments_claim(cone_law<faults::HalfCone>())},
       {mean_claim(cone<faults::HalfCone>())}},
      {.name = "cosine-exponent-a-ten-thousandth",
       .kind = "cosine sampler",
       .source = "the class of raytracing.github.io #145",
       .claims = {mean_claim<Packet>(hardly_steep)},
       .survives =
           "a bias of 2e-5, a fiftieth of the margin: to certify or to refute it takes 2500 times as many draws"}};
}

}  // namespace fairlight

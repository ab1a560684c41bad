#include <fairlight/validation/analytic/directions.h>
#include <fairlight/validation/analytic/glossy.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_directions.h>

namespace fairlight {
namespace {

Fault theta_uniform_cone() {
  const auto integral = cone_integral<faults::ThetaUniformCone>("importance.cone", 0.75);
  const auto narrow = cone_integral<faults::ThetaUniformCone>("importance.cone.narrow", 1e-16);
  return {"cone-theta-uniform",
          "cone sampler",
          "openmc #2041; appleseed #2851",
          {law_claim(cone_law<faults::ThetaUniformCone>()), law_moments_claim(cone_law<faults::ThetaUniformCone>()),
           law_moments_claim<Packet>(cone_law<faults::ThetaUniformCone>()), mean_claim(integral),
           mean_claim<Packet>(integral), mean_claim(narrow), mean_claim<Packet>(narrow)}};
}

Fault collapsed_cone() {
  const auto narrow = cone_integral<faults::CollapsedCone>("importance.cone.narrow", 1e-16);
  return {"cone-collapsed", "cancellation", "pbrt-v3 #212", {mean_claim(narrow), mean_claim<Packet>(narrow)}};
}

Fault blunt_lobe() {
  const auto law = lobe_law<faults::BluntLobe>("lobe.power", 20);
  const auto integral = lobe_integral<faults::BluntLobe>("importance.lobe", 5);
  const auto albedo = glossy_normal<faults::BluntGlossy>();
  return {"lobe-exponent",
          "lobe sampler",
          "raytracing.github.io #145",
          {law_claim(law), law_moments_claim(law), law_moments_claim<Packet>(law), mean_claim(integral),
           mean_claim<Packet>(integral), mean_claim(albedo), mean_claim<Packet>(albedo)}};
}

Fault leaky_glossy() {
  const auto albedo = glossy_oblique<faults::LeakyGlossy>();
  return {"glossy-below-surface", "support", "dspbr-pt #5", {mean_claim(albedo), mean_claim<Packet>(albedo)}};
}

}  // namespace

std::vector<Fault> direction_faults() {
  return {theta_uniform_cone(), collapsed_cone(), blunt_lobe(), leaky_glossy()};
}

}  // namespace fairlight

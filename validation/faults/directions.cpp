#include <fairlight/validation/claims/directions.h>
#include <fairlight/validation/claims/glossy.h>
#include <fairlight/validation/claims/integrals.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_directions.h>

namespace fairlight {
namespace {

Fault theta_uniform_cone() {
  const auto integral = cone_integral<faults::ThetaUniformCone>("importance.cone", 0.75);
  return {"cone-theta-uniform",
          "cone sampler",
          "openmc #2041; appleseed #2851",
          {law_moments_claim(cone_law<faults::ThetaUniformCone>()), mean_claim<Packet>(integral)}};
}

Fault collapsed_cone() {
  const auto narrow = cone_integral<faults::CollapsedCone>("importance.cone.narrow", 1e-16);
  return {"cone-collapsed", "cancellation", "pbrt-v3 #212", {mean_claim(narrow), mean_claim<Packet>(narrow)}};
}

Fault blunt_lobe() {
  const auto integral = lobe_integral<faults::BluntLobe>("importance.lobe", 5);
  const auto albedo = glossy_normal<faults::BluntGlossy>();
  return {"lobe-exponent",
          "lobe sampler",
          "raytracing.github.io #145",
          {mean_claim(integral), mean_claim<Packet>(albedo)}};
}

Fault leaky_glossy() {
  const auto albedo = glossy_oblique<faults::LeakyGlossy>();
  return {"glossy-below-surface", "support", "dspbr-pt #5", {mean_claim<Packet>(albedo)}};
}

Fault half_density() {
  return {"cosine-density-halved",
          "cosine sampler",
          "raytracing.github.io #145",
          {law_claim(cosine_law<faults::HalfCosineDensity>())}};
}

Fault crowded_cosine() {
  return {"cosine-without-root",
          "cosine sampler",
          "raytracing.github.io #145",
          {law_moments_claim(cosine_law<faults::CrowdedCosine>())}};
}

// A fault that an integral hides: the integrand does not depend on the azimuth.
Fault half_cone() {
  return {"cone-half-turn",
          "two wrongs",
          "the class of raytracing.github.io #933",
          {law_moments_claim(cone_law<faults::HalfCone>())},
          {mean_claim(cone_integral<faults::HalfCone>("importance.cone", 0.75))}};
}

Fault hardly_steep_cosine() {
  return {
      .name = "cosine-exponent-a-ten-thousandth",
      .kind = "cosine sampler",
      .source = "the class of raytracing.github.io #145",
      .claims = {mean_claim<Packet>(hemisphere_integral<faults::HardlySteepCosine>(
          "importance.cosine.cosine_squared", "", 2, std::numbers::pi))},
      .survives =
          "a bias of 2e-5, a fiftieth of the margin: to certify or to refute it takes 2500 times as many draws"};
}

}  // namespace

std::vector<Fault> direction_faults() {
  return {theta_uniform_cone(), collapsed_cone(), blunt_lobe(), leaky_glossy(),
          half_density(),       crowded_cosine(), half_cone(),  hardly_steep_cosine()};
}

}  // namespace fairlight

#include <fairlight/validation/checks/law_claims.h>
#include <fairlight/validation/claims/combinator_agreements.h>
#include <fairlight/validation/claims/furnace.h>
#include <fairlight/validation/claims/integrals.h>
#include <fairlight/validation/claims/sphere_over_plane.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_components.h>

namespace fairlight {
namespace {

template <class Direct, class Roulette>
using Tracer = PathTracer<BouncesBy<CosineHemisphere>, Direct, Roulette>;
using All = DirectLight<AllLights>;
using Unpaid = RouletteByReflectance<faults::UnpaidRoulette>;

double all_terms(const SpheresOverPlane& scene, int channel) { return scene.sum_of_terms(channel); }

std::vector<Fault> first_faults() {
  using Theta = PointsBy<faults::SphereByTheta>;
  using Wrong = Tracer<DirectLight<faults::OneUnweighted, PointsBy<SphereByCone>>, NoRoulette>;
  using Right = Tracer<DirectLight<AllLights, PointsBy<SphereByCone>>, NoRoulette>;
  const auto steep_cosine = hemisphere_integral<faults::SteepCosineHemisphere>("importance.cosine.cosine_squared",
                                                                               "", 2, std::numbers::pi);
  return {{"sphere-theta-uniform",
           "Montelight",
           "Smerity/montelight-cpp",
           {law_moments_claim<Packet>(sphere_area_law<faults::ThetaUniformSphere>()),
            mean_claim(floor_radiance<Tracer<DirectLight<AllLights, Theta>, NoRoulette>>(
                "sphere_over_plane.light", {}, one_light(), 1, all_terms))}},
          {"roulette-unpaid",
           "roulette unpaid",
           "openmc #3511; chunky #1018; Montelight",
           {mean_claim(roulette_integral<faults::UnpaidRoulette>("roulette.integral", 0.3)),
            mean_claim(furnace_radiance<Tracer<NoDirectLight, Unpaid>>("furnace.bounce", {})),
            mean_claim(roulette_on_against_off<Tracer<All, Unpaid>, Tracer<All, NoRoulette>>("cornell.roulette"))}},
          {"one-light-unweighted",
           "luminaire probability",
           "LuxCore #68",
           {mean_claim(two_dice<faults::OneUnweighted>("pick.one.dice", {})),
            mean_claim<Packet>(one_against_all<Wrong, Right>("two_lights.one_against_all"))}},
          {"cosine-exponent-2-percent",
           "cosine sampler",
           "raytracing.github.io #145",
           {mean_claim<Packet>(steep_cosine)}}};
}

}  // namespace

const std::vector<Fault>& fault_catalogue() {
  static const std::vector<Fault> faults = [] {
    std::vector<Fault> all = first_faults();
    for (const auto more : {direction_faults, microfacet_faults, material_faults, light_faults, light_domain_faults,
                            triangle_faults, combinator_faults, combinator_domain_faults, random_faults,
                            camera_faults, allocation_faults, path_tracer_faults, direct_light_faults,
                            relation_faults, second_order_faults, whole_domain_faults, picture_faults}) {
      for (const Fault& fault : more()) all.push_back(fault);
    }
    return all;
  }();
  return faults;
}

}  // namespace fairlight

#include <fairlight/validation/claims/closed_scenes.h>
#include <fairlight/validation/claims/furnace.h>
#include <fairlight/validation/claims/paired_boxes.h>
#include <fairlight/validation/claims/sphere_over_plane.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_direct_light.h>
#include <fairlight/validation/faults/wrong_tracers.h>

namespace fairlight {
namespace {

template <class Direct>
std::vector<Claim> in_furnace() {
  using Tracer = PathTracer<BouncesBy<CosineHemisphere>, Direct, RouletteByReflectance<>>;
  return {mean_claim(furnace_radiance<Tracer>("furnace.light", {}, 2))};
}

template <class Direct>
std::vector<Claim> with_mirror(const std::string& how) {
  return {mean_claim(mirror_in_furnace<Direct>(how, {}))};
}

}  // namespace

std::vector<Fault> direct_light_faults() {
  using AtWrongVertex = DirectLight<AllLights, faults::DensityAtWrongVertex, MisWeighted<>>;
  using InFull = DirectLight<AllLights, PointsBy<SphereByCone>, faults::SharedByShadowRaysAlone>;
  using Mixed = DirectLight<AllLights, PointsBy<SphereByCone>, faults::MixedHeuristics>;
  using LitByThemselves = DirectLight<AllLights, faults::RectanglesLightThemselves>;
  return {
      {"emission-twice", "double count", "the paper, A.2", in_furnace<faults::EmissionTwice>()},
      {"emission-unseen", "emission lost", "mitsuba3 #1540", in_furnace<faults::EmissionUnseen>()},
      {"light-after-roulette", "roulette out of order", "vk_raytrace #13; openmc #241",
       in_furnace<faults::LightAfterRoulette>()},
      {"mirror-to-shadow-rays", "MIS of a delta", "three-gpu-pathtracer #174",
       with_mirror<faults::MirrorsToShadowRays>("light")},
      {"mirror-with-density", "MIS of a delta", "three-gpu-pathtracer #174",
       with_mirror<faults::MirrorsWithDensity>("shared")},
      {"mis-density-at-wrong-vertex", "MIS sum", "mitsuba aa325039f", {mean_claim(shared_light<AtWrongVertex>())}},
      {"mis-bounces-in-full", "MIS sum", "Moer #59", {mean_claim(shared_light<InFull>())}},
      {"mis-heuristics-mixed",
       "MIS sum",
       "the class of Moer #59",
       {mean_claim(shared_light<Mixed>()), paired_claim<WholePicture, faults::SharedByMixedHeuristics>(
                                               measured_box_shared(), measured_box_picture(), 4)}},
      {"mis-light-probability-forgotten",
       "luminaire probability",
       "redner #56",
       {mean_claim(shared_lights<faults::ChanceForgottenByBounces>())}},
      {"rectangles-light-themselves",
       "epsilon",
       "fairlight before 0.1.0",
       {mean_claim<Packet>(in_lit_box<LitByThemselves>("direct"))}}};
}

}  // namespace fairlight

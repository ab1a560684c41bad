#include <fairlight/validation/checks/law_claims.h>
#include <fairlight/validation/claims/furnace.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_directions.h>
#include <fairlight/validation/faults/wrong_tracers.h>

namespace fairlight {
namespace {

template <template <class> class Directions>
using TracerBy = PathTracer<BouncesBy<Directions>, NoDirectLight, RouletteByReflectance<>>;
using Tracer = TracerBy<CosineHemisphere>;
using ByCone = DirectLight<AllLights, PointsBy<SphereByCone>>;
using FixedDepth = PathTracer<BouncesBy<CosineHemisphere>, ByCone, NoRoulette>;

// The row of the furnace with bounces alone.
template <class Wrong>
std::vector<Claim> by_bounces() {
  return {mean_claim(furnace_radiance<Wrong>("furnace.bounce", {}))};
}

}  // namespace

std::vector<Fault> path_tracer_faults() {
  using InTheSmall = faults::TracerIn<Tracer, faults::NearHitsIgnored<3>::In>;
  using ShadowRays = PathTracer<BouncesBy<CosineHemisphere>, ByCone, RouletteByReflectance<>>;
  using Shadowed = faults::TracerIn<ShadowRays, faults::ShadowedByItself>;
  return {{"depth-called-endless", "truncation", "rpt #5", by_bounces<faults::Truncated<Tracer, 8>>()},
          {"one-bounce-more",
           "truncation",
           "pbrt-v3 #69",
           {mean_claim(furnace_partial_sum<faults::OneBounceMore<FixedDepth>>("furnace.depth3.cone", {}, 3, 2))}},
          {"samples-clamped", "Montelight", "Smerity/montelight-cpp", by_bounces<faults::Clamped<Tracer>>()},
          {"outliers-left-out", "outliers", "the class of three-gpu-pathtracer #825",
           by_bounces<faults::WithoutOutliers<Tracer>>()},
          {"grazing-clipped", "energy", "dspbr-pt #5", by_bounces<TracerBy<faults::GrazingClipped>>()},
          {"near-hits-ignored",
           "epsilon",
           "SORT #29",
           {mean_claim(furnace_radiance<InTheSmall>("furnace.tiny.bounce", {}, 5, Furnace(1e-3)))}},
          {"shadow-acne",
           "epsilon",
           "mitsuba3 #785",
           {mean_claim<Packet>(two_spheres("furnace.two_spheres.cone", {}, 4.1, always(Shadowed())))}},
          {"uniform-called-cosine",
           "two wrongs",
           "raytracing.github.io #933",
           {law_moments_claim(cosine_law<faults::UniformCalledCosine>())},
           by_bounces<TracerBy<faults::UniformCalledCosine>>()}};
}

}  // namespace fairlight

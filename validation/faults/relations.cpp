#include <fairlight/validation/claims/scene_relations.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_tracers.h>

namespace fairlight {
namespace {

// Tracers of any strategies, with scenes that answer rays wrongly.
template <class Tracer>
using FromAMicron = faults::TracerIn<Tracer, faults::NearHitsIgnored<6>::In>;
template <class Tracer>
using FromAMillimetre = faults::TracerIn<Tracer, faults::ShadowsFromAMillimetre>;
template <class Tracer>
using ByTheOrigin = faults::TracerIn<Tracer, faults::ShadowsByTheOrigin>;
template <class Tracer>
using ZeroIsNone = faults::TracerIn<Tracer, faults::SurfaceZeroIsNone>;
template <class Tracer>
using Upwards = faults::TracerIn<Tracer, faults::NormalsUpwards>;

}  // namespace

std::vector<Fault> relation_faults() {
  return {{"shadow-rays-from-a-millimetre",
           "epsilon",
           "GLSL-PathTracer #35",
           {same_paths<Packet, FromAMillimetre>(larger("cornell-materials"))}},
          {"near-hits-ignored-by-a-micron",
           "epsilon",
           "the class of SORT #29",
           {same_paths<double, FromAMicron>(smaller("cornell-materials"))}},
          {"shadow-rays-by-the-origin",
           "epsilon",
           "mitsuba3 #1962",
           {mean_claim_alone<double>(far_away<ByTheOrigin>(far_for_doubles))}},
          {"surface-zero-is-none",
           "index",
           "the class of an index that is asked whether it is true",
           {mean_claim(reversed_lights<ZeroIsNone>())}},
          {"normals-upwards", "axis", "the class of ByroRedux #3922", {mean_claim<Packet>(turned_box<Upwards>())}},
          {"samples-clamped-by-the-unit",
           "outliers",
           "the class of Smerity/montelight-cpp",
           {same_paths<double, faults::Clamped>(brighter("cornell-simple"))}}};
}

}  // namespace fairlight

#include <fairlight/validation/claims/lights.h>
#include <fairlight/validation/claims/picks.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_lights.h>

namespace fairlight {
namespace {

// The bounds are those of the wrong draws, so that only the mean shows the fault.

template <template <class> class Strategy>
auto far_sphere(double factor) {
  const SphereFromOrigin far{{3, 4, 12}, 1};
  return sphere_irradiance_claim<Strategy>("sphere_light.by_visible.above", "", far, {0, 0, 1},
                                           far.area_bound() * factor);
}

}  // namespace

std::vector<Fault> light_faults() {
  const SphereFromOrigin near{{1, 2, 2.5}, 2};
  const RectangleFromOrigin beside{{0.5, -0.5, 1}, 1.5, 2};
  const ManyLights lights(1000, 0.5);
  return {
      {"sphere-radius-written-in", "Montelight", "Smerity/montelight-cpp",
       both(sphere_irradiance_claim<faults::RadiusWrittenIn>("sphere_light.by_cone.above", "", near, {0, 0, 1},
                                                             near.cone_bound()))},
      {"area-cosine-missing", "measure", "Baikal #82; AdaPT #22", both(far_sphere<faults::CosineMissing>(0.5))},
      {"rectangle-area-for-solid-angle", "measure", "pbrt-v4 d86222e6",
       both(rectangle_irradiance_claim<faults::AreaForSolidAngle>("rectangle.by_area.perpendicular", "", beside,
                                                                  {1, 0, 0}, beside.width * beside.height))},
      {"power-weighted-by-number", "luminaire probability", "ospray #552",
       both(sum_by_power<faults::PowerWeightedByNumber>("pick.power.1000", lights, lights.largest_of_n()))},
      {"distance-not-squared", "measure", "Baikal #82", both(far_sphere<faults::DistanceNotSquared>(7))},
      {"visible-half-density-of-whole", "sample against pdf", "pbrt-v4 #215",
       both(far_sphere<faults::HalfWithDensityOfWhole>(1))},
      {"thresholds-not-cumulative", "lobe selection", "UnitySSPathTracingURP #8",
       both(sum_by_power<faults::ThresholdsNotCumulative>("pick.power.1000", lights, lights.largest_by_power()))}};
}

}  // namespace fairlight

#include <fairlight/validation/claims/lights.h>
#include <fairlight/validation/claims/picks.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_lights.h>

namespace fairlight {
namespace {

const Vec3<double> up(0, 0, 1);
const Vec3<double> aside(1, 0, 0);

template <class Draw>
std::vector<Claim> both(const Estimand<Draw>& e) {
  return {mean_claim<double>(e), mean_claim<Packet>(e)};
}

// The bounds are those of the wrong draws, so that only the mean shows the fault.
Fault radius_written_in() {
  const SphereFromOrigin near{{1, 2, 2.5}, 2};
  return {"sphere-radius-written-in", "Montelight", "Smerity/montelight-cpp",
          both(sphere_irradiance_claim<faults::RadiusWrittenIn>("sphere_light.by_cone.above", "", near, up,
                                                                near.cone_bound()))};
}

Fault cosine_missing() {
  const SphereFromOrigin far{{3, 4, 12}, 1};
  return {"area-cosine-missing", "measure", "Baikal #82; AdaPT #22",
          both(sphere_irradiance_claim<faults::CosineMissing>("sphere_light.by_visible.above", "", far, up,
                                                              far.area_bound() / 2))};
}

Fault area_for_solid_angle() {
  const RectangleFromOrigin beside{{0.5, -0.5, 1}, 1.5, 2};
  return {"rectangle-area-for-solid-angle", "measure", "pbrt-v4 d86222e6",
          both(rectangle_irradiance_claim<faults::AreaForSolidAngle>("rectangle.by_area.perpendicular", "", beside,
                                                                     aside, beside.width * beside.height))};
}

Fault power_weighted_by_number() {
  const ManyLights lights(1000, 0.5);
  return {"power-weighted-by-number", "luminaire probability", "ospray #552",
          both(sum_by_power<faults::PowerWeightedByNumber>("pick.power.1000", lights, lights.largest_of_n()))};
}

Fault distance_not_squared() {
  const SphereFromOrigin far{{3, 4, 12}, 1};
  return {"distance-not-squared", "measure", "Baikal #82",
          both(sphere_irradiance_claim<faults::DistanceNotSquared>("sphere_light.by_visible.above", "", far, up,
                                                                   far.area_bound() * 7))};
}

Fault half_with_density_of_whole() {
  const SphereFromOrigin far{{3, 4, 12}, 1};
  return {"visible-half-density-of-whole", "sample against pdf", "pbrt-v4 #215",
          both(sphere_irradiance_claim<faults::HalfWithDensityOfWhole>("sphere_light.by_visible.above", "", far, up,
                                                                       far.area_bound()))};
}

Fault thresholds_not_cumulative() {
  const ManyLights lights(1000, 0.5);
  return {
      "thresholds-not-cumulative", "lobe selection", "UnitySSPathTracingURP #8",
      both(sum_by_power<faults::ThresholdsNotCumulative>("pick.power.1000", lights, lights.largest_by_power()))};
}

}  // namespace

std::vector<Fault> light_faults() {
  return {radius_written_in(),        cosine_missing(),       area_for_solid_angle(),
          power_weighted_by_number(), distance_not_squared(), half_with_density_of_whole(),
          thresholds_not_cumulative()};
}

}  // namespace fairlight

#include <fairlight/validation/claims/lights_at_any_distance.h>
#include <fairlight/validation/claims/rendered_variance.h>
#include <fairlight/validation/claims/signed_integrals.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_combinators.h>
#include <fairlight/validation/faults/wrong_lights.h>
#include <fairlight/validation/faults/wrong_pictures.h>

namespace fairlight {

// Faults in a part of the domain alone: near lights, bright pictures, negative draws, many samples.
std::vector<Fault> whole_domain_faults() {
  using Values = std::vector<double>;
  const DistanceRange near = distance_ranges[0];
  std::vector<Claim> bright, repeated, rectangle, sphere, cut;
  for (const Arithmetic real : {Arithmetic::doubles, Arithmetic::packets}) {
    bright.push_back(picture_of_brightness<faults::SamplesClampedAt100>(real, "white_ball_bright", 3e4));
  }
  repeated.push_back(variance_of_pixels<faults::SamplesRepeatedAfter64>(Arithmetic::packets, 128));
  add_mean_over(rectangle, drawn_distance("RectangleByArea", near), [](const Values& values) {
    return rectangle_at_any_distance<faults::RectangleFloored>("rectangle.by_area.at_any_distance.near", "", 1,
                                                               values);
  });
  add_mean_over(sphere, drawn_distance("SphereByVisibleHemisphere", near), [](const Values& values) {
    return sphere_at_any_distance<faults::SphereFloored>("sphere_light.by_visible.at_any_distance.near", "", 0.5,
                                                         values);
  });
  add_mean_over(cut, signed_coefficients("ControlVariate"),
                [](const Values& values) { return signed_control_variate<faults::NegativeDrawsCut>(values); });
  return {{"samples-clamped-at-100", "Montelight", "the class of Smerity/montelight-cpp", bright},
          {"samples-repeated-after-64", "reused number", "the class of SORT #35", repeated},
          {"rectangle-distance-floored", "epsilon", "the class of SORT #29", rectangle},
          {"sphere-distance-floored", "epsilon", "the class of SORT #29", sphere},
          {"control-variate-negative-draws-cut", "Montelight", "the class of Smerity/montelight-cpp", cut}};
}

}  // namespace fairlight

#include <fairlight/validation/claims/rendered_variance.h>
#include <fairlight/validation/claims/signed_integrals.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_combinators.h>
#include <fairlight/validation/faults/wrong_pictures.h>

namespace fairlight {

// Faults in a part of the domain alone: bright pictures, negative draws, many samples.
std::vector<Fault> whole_domain_faults() {
  using Values = std::vector<double>;
  std::vector<Claim> bright, repeated, cut;
  for (const Arithmetic real : {Arithmetic::doubles, Arithmetic::packets}) {
    bright.push_back(picture_of_brightness<faults::SamplesClampedAt100>(real, "white_ball_bright", 3e4));
  }
  repeated.push_back(variance_of_pixels<faults::SamplesRepeatedAfter64>(Arithmetic::packets, 128));
  add_mean_over(cut, signed_coefficients("ControlVariate"),
                [](const Values& values) { return signed_control_variate<faults::NegativeDrawsCut>(values); });
  return {{"samples-clamped-at-100", "Montelight", "the class of Smerity/montelight-cpp", bright},
          {"samples-repeated-after-64", "reused number", "the class of SORT #35", repeated},
          {"control-variate-negative-draws-cut", "Montelight", "the class of Smerity/montelight-cpp", cut}};
}

}  // namespace fairlight

#include <fairlight/validation/checks/bsdf_expectation.h>

namespace fairlight {

Expectation expect_bsdf(const Site& site, const BsdfUnderTest& bsdf, const BsdfTerms& terms) {
  const Trial trial = trial_at(site, terms.margin);
  return expectation_of(site, trial, check_bsdf(trial, bsdf, terms));
}

}  // namespace fairlight

#include <fairlight/estimators/allocation_unbiased.h>
#include <fairlight/validation/claims/combinator_variances.h>
#include <fairlight/validation/claims/point_sets.h>
#include <fairlight/validation/claims/roulette_walk.h>
#include <fairlight/validation/claims/spiky_pixels.h>
#include <fairlight/validation/claims/streams.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_combinators.h>
#include <fairlight/validation/faults/wrong_point_sets.h>

namespace fairlight {
namespace {

// Faults that keep the mean. A variance, a correlation or a cost shows them.

template <template <class> class Set>
Fault of_points(const std::string& name, const std::string& source, const std::string& suffix, std::uint32_t n) {
  const PointSetKind<Set> wrong{suffix, ""};
  return {name,
          "randomisation",
          source,
          {stratified_variance_claim(wrong, n, n)},
          {replicates_claim(product_integral(), wrong, 1)}};
}

Fault adaptivity_off() {
  const AllocationPlan plan{PixelGrid(4, 2), 128, 4};
  const DiscardedPilot<UniformAllocation> off(plan);
  const DiscardedPilot<UniformAllocation> uniform({plan.grid, plan.budget, 0});
  return {"adaptivity-off",
          "strategy off",
          "none: a setting that does not arrive",
          {quieter_allocation("allocation.pilot.deviation.quieter", {}, 0.6, off, uniform)}};
}

Fault roulette_at_its_cap() {
  using Wrong = faults::RouletteAtItsCap;
  return {"roulette-at-its-cap",
          "survival above 1",
          "practical-path-guiding #3",
          {mean_claim(roulette_walk_length<Wrong>())},
          {mean_claim(roulette_walk<Wrong, CosineHemisphere>("roulette.walk.reflectance", "", 1))}};
}

Fault one_pixel() {
  return {"pixels-share-numbers",
          "streams",
          "the class of SORT #35",
          {streams_uncorrelated_claim<faults::NumbersOfOnePixel>()}};
}

Fault one_vertex() {
  return {"vertices-share-numbers",
          "streams",
          "OpenCL-path-tracing-tutorial-3-Part-2 #2",
          {streams_uncorrelated_claim<faults::NumbersOfOneVertex>()}};
}

Fault one_run() {
  return {"splitting-repeats-itself",
          "streams",
          "the class of SORT #35",
          {splitting_variance<faults::SplittingOfOneRun>()},
          {mean_claim(splitting_integral<faults::SplittingOfOneRun>("splitting.whole", 3))}};
}

}  // namespace

std::vector<Fault> second_order_faults() {
  return {
      of_points<faults::SobolWithoutFirst>("sobol-first-point-dropped", "pytorch #32047; scikit-optimize #953",
                                           "sobol", 16),
      of_points<faults::ShiftedSobol>("sobol-shifted-not-scrambled", "openturns #2686", "sobol", 16),
      of_points<faults::OneJitterLatinHypercube>("latin-one-jitter", "the class of openturns #2686", "latin", 16),
      {"lights-share-numbers",
       "streams",
       "the class of zenphoton #8",
       {all_against_one<faults::AllOfOneNumber>()},
       {mean_claim(two_dice<faults::AllOfOneNumber>("pick.all.dice", {}))}},
      {"control-drawn-apart",
       "strategy off",
       "none: a slip of the formula",
       {control_variate_variance<faults::ControlDrawnApart>()},
       {mean_claim(control_variate_integral<faults::ControlDrawnApart>("control_variate.integral"))}},
      {"strata-forgotten",
       "strategy off",
       "none: a setting that does not arrive",
       {stratified_mean_variance<faults::StrataForgotten>()},
       {mean_claim(stratified_integral<faults::StrataForgotten>("stratified.integral"))}},
      roulette_at_its_cap(),
      adaptivity_off(),
      one_pixel(),
      one_vertex(),
      one_run()};
}

}  // namespace fairlight

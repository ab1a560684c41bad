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

// A point set whose variance shows the fault.
template <template <class> class Set>
Fault of_points(const std::string& name, const std::string& source, const std::string& suffix) {
  const PointSetKind<Set> wrong{suffix, ""};
  return {name,
          "randomisation",
          source,
          {stratified_variance_claim(wrong, 16, 16)},
          {replicates_claim(product_integral(), wrong, 1)}};
}

// A claim that shows the fault, of a variance or a cost, and a mean that does not.
Fault of_same_mean(const std::string& name, const std::string& kind, const std::string& source, const Claim& caught,
                   const auto& mean) {
  return {name, kind, source, {caught}, {mean_claim(mean)}};
}

Claim quieter_without_adaptivity() {
  const AllocationPlan plan{PixelGrid(4, 2), 128, 4};
  const DiscardedPilot<UniformAllocation> off(plan);
  const DiscardedPilot<UniformAllocation> uniform({plan.grid, plan.budget, 0});
  return quieter_allocation("allocation.pilot.deviation.quieter", {}, 0.6, off, uniform);
}

}  // namespace

std::vector<Fault> second_order_faults() {
  const std::string off = "strategy off", slip = "none: a slip of the formula",
                    setting = "none: a setting that does not arrive";
  return {
      of_points<faults::SobolWithoutFirst>("sobol-first-point-dropped", "pytorch #32047; scikit-optimize #953",
                                           "sobol"),
      of_points<faults::ShiftedSobol>("sobol-shifted-not-scrambled", "openturns #2686", "sobol"),
      of_points<faults::OneJitterLatinHypercube>("latin-one-jitter", "the class of openturns #2686", "latin"),
      of_same_mean("lights-share-numbers", "streams", "the class of zenphoton #8",
                   all_against_one<faults::AllOfOneNumber>(),
                   two_dice<faults::AllOfOneNumber>("pick.all.dice", {})),
      of_same_mean("control-drawn-apart", off, slip, control_variate_variance<faults::ControlDrawnApart>(),
                   control_variate_integral<faults::ControlDrawnApart>("control_variate.integral")),
      of_same_mean("strata-forgotten", off, setting, stratified_mean_variance<faults::StrataForgotten>(),
                   stratified_integral<faults::StrataForgotten>("stratified.integral")),
      of_same_mean("roulette-at-its-cap", "survival above 1", "practical-path-guiding #3",
                   mean_claim(roulette_walk_length<faults::RouletteAtItsCap>()),
                   roulette_walk<faults::RouletteAtItsCap, CosineHemisphere>("roulette.walk.reflectance", "", 1)),
      {"adaptivity-off", off, setting, {quieter_without_adaptivity()}},
      {"pixels-share-numbers",
       "streams",
       "the class of SORT #35",
       {streams_uncorrelated_claim<faults::NumbersOfOnePixel>()}},
      {"vertices-share-numbers",
       "streams",
       "OpenCL-path-tracing-tutorial-3-Part-2 #2",
       {streams_uncorrelated_claim<faults::NumbersOfOneVertex>()}},
      of_same_mean("splitting-repeats-itself", "streams", "the class of SORT #35",
                   splitting_variance<faults::SplittingOfOneRun>(),
                   splitting_integral<faults::SplittingOfOneRun>("splitting.whole", 3))};
}

}  // namespace fairlight

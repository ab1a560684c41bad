#include <fairlight/validation/claims/combinations.h>
#include <fairlight/validation/claims/furnace.h>
#include <fairlight/validation/claims/long_sums.h>
#include <fairlight/validation/claims/roulette_walk.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_combinators.h>
#include <fairlight/validation/faults/wrong_components.h>

namespace fairlight {
namespace {

Fault unpaid_throughput() {
  using Unpaid = RouletteByThroughput<faults::UnpaidRoulette>;
  using Tracer = PathTracer<BouncesBy<CosineHemisphere>, NoDirectLight, Unpaid>;
  return {"roulette-by-throughput-unpaid",
          "roulette unpaid",
          "openmc #3511; chunky #1018",
          {mean_claim(roulette_walk<Unpaid, UniformHemisphere>("roulette.walk.throughput", "", 2)),
           mean_claim(furnace_radiance<Tracer>("furnace.throughput", {}))}};
}

}  // namespace

std::vector<Fault> combinator_faults() {
  using OneSide = faults::PowerOnOneSide;
  return {unpaid_throughput(),
          {"roulette-spared-paid", "roulette unpaid", "none: a slip of the mask",
           both(later_roulette_walk<faults::SparedPaid>())},
          {"roulette-a-bounce-late", "roulette out of order", "none: what is carried, before the vertex's albedo",
           both(later_roulette_walk_length<faults::CarriedBefore>())},
          {"mis-power-on-one-side", "MIS sum", "mitsuba aa325039f; Moer #59",
           both(multi_sample_peaks<OneSide>("mis.peaks.power", {}),
                one_sample_peaks<OneSide>("mis.one_sample.power", {}),
                solid_angle_by_two<OneSide>("mis.hemisphere.power"))},
          {"mis-counts-ignored", "MIS sum", "appleseed #1515",
           both(multi_sample_peaks<faults::CountsIgnored>("mis.peaks.balance", {}))},
          {"mis-selection-unpaid", "luminaire probability", "LuxCore #68",
           both(one_sample_peaks<faults::SelectionUnpaid>("mis.one_sample.balance", {}))},
          {"control-variate-sign", "weight", "none: a slip of the formula",
           both(control_variate_integral<faults::WrongSign>("control_variate.integral"))},
          {"control-variate-factor", "weight", "none: a slip of the formula",
           both(control_variate_integral<faults::FactorForgotten>("control_variate.integral"))},
          {"splitting-unpaid", "lost 1/n", "appleseed #1515; mitsuba3 #1861",
           both(splitting_integral<faults::UnpaidSplitting>("splitting.whole", 3),
                splitting_integral<faults::UnpaidSplitting>("splitting.fraction", 2.25))},
          {"strata-half-jitter", "support", "pbrt-v3 #319, a hole in the samples",
           both(stratified_integral<faults::HalfJitter>("stratified.integral"))},
          {"mis-densities-swapped", "MIS sum", "three-gpu-pathtracer #847",
           both(solid_angle_by_two<faults::DensitiesSwapped>("mis.hemisphere.power"))},
          {"roulette-paid-by-mean", "luminaire probability", "ospray #552",
           both(roulette_walk<faults::RoulettePaidByMean, CosineHemisphere>("roulette.walk.reflectance", "", 1))},
          {"light-number-reused", "reused number", "pbrt-v4 795c619b",
           both(two_dice<faults::OneOfReusingNumbers>("pick.one.dice", {}))},
          {"sum-of-floats", "float sum", "ice_halo_sim #380", {long_sum_claim<faults::PlainSum>()}}};
}

}  // namespace fairlight

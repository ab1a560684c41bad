#include <fairlight/validation/analytic/combinations.h>
#include <fairlight/validation/analytic/furnace.h>
#include <fairlight/validation/analytic/roulette_walk.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_combinators.h>
#include <fairlight/validation/faults/wrong_components.h>

namespace fairlight {
namespace {

// The rows of an experiment, in double and in packets.
template <class Experiment>
std::vector<Claim> both(const Experiment& wrong) {
  return {mean_claim<double>(wrong), mean_claim<Packet>(wrong)};
}

std::vector<Claim> together(std::vector<Claim> claims, const std::vector<Claim>& more) {
  claims.insert(claims.end(), more.begin(), more.end());
  return claims;
}

Fault unpaid_throughput() {
  using Unpaid = RouletteByThroughput<0, faults::UnpaidRoulette>;
  using UnpaidLater = RouletteByThroughput<1, faults::UnpaidRoulette>;
  using Tracer = PathTracer<BouncesBy<CosineHemisphere>, NoDirectLight, Unpaid>;
  const auto claims = together(
      together(both(roulette_walk<Unpaid, UniformHemisphere>("roulette.walk.throughput", "", 0)),
               both(roulette_walk<UnpaidLater, UniformHemisphere>("roulette.walk.throughput_later", "", 1))),
      both(furnace_radiance<Tracer>("furnace.throughput", {})));
  return {"roulette-by-throughput-unpaid", "roulette unpaid", "openmc #3511; chunky #1018", claims};
}

Fault weights_on_one_side() {
  using Wrong = faults::PowerOnOneSide;
  return {"mis-power-on-one-side", "MIS sum", "mitsuba aa325039f; Moer #59",
          together(together(both(multi_sample_peaks<Wrong>("mis.peaks.power")),
                            both(one_sample_peaks<Wrong>("mis.one_sample.power"))),
                   both(solid_angle_by_two<Wrong>("mis.hemisphere.power")))};
}

Fault counts_ignored() {
  return {"mis-counts-ignored", "MIS sum", "appleseed #1515",
          both(multi_sample_peaks<faults::CountsIgnored>("mis.peaks.balance"))};
}

Fault selection_unpaid() {
  return {"mis-selection-unpaid", "luminaire probability", "LuxCore #68",
          both(one_sample_peaks<faults::SelectionUnpaid>("mis.one_sample.balance"))};
}

Fault wrong_sign() {
  return {"control-variate-sign", "weight", "none: a slip of the formula",
          both(control_variate_integral<faults::WrongSign>("control_variate.integral"))};
}

Fault factor_forgotten() {
  return {"control-variate-factor", "weight", "none: a slip of the formula",
          both(control_variate_integral<faults::FactorForgotten>("control_variate.integral"))};
}

Fault unpaid_splitting() {
  return {"splitting-unpaid", "lost 1/n", "appleseed #1515; mitsuba3 #1861",
          together(both(splitting_integral<faults::UnpaidSplitting>("splitting.whole", 3)),
                   both(splitting_integral<faults::UnpaidSplitting>("splitting.fraction", 2.25)))};
}

Fault half_jitter() {
  return {"strata-half-jitter", "support", "pbrt-v3 #319, a hole in the samples",
          both(stratified_integral<faults::HalfJitter>("stratified.integral"))};
}

}  // namespace

std::vector<Fault> combinator_faults() {
  return {unpaid_throughput(), weights_on_one_side(), counts_ignored(),   selection_unpaid(),
          wrong_sign(),        factor_forgotten(),    unpaid_splitting(), half_jitter()};
}

}  // namespace fairlight

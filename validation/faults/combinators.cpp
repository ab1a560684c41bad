#include <fairlight/validation/claims/combinations.h>
#include <fairlight/validation/claims/furnace.h>
#include <fairlight/validation/claims/long_sums.h>
#include <fairlight/validation/claims/roulette_walk.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_combinators.h>
#include <fairlight/validation/faults/wrong_components.h>

namespace fairlight {
namespace {

// The rows of an estimand, in double and in packets.
template <class Estimand>
std::vector<Claim> both(const Estimand& wrong) {
  return {mean_claim<double>(wrong), mean_claim<Packet>(wrong)};
}

std::vector<Claim> together(std::vector<Claim> claims, const std::vector<Claim>& more) {
  claims.insert(claims.end(), more.begin(), more.end());
  return claims;
}

Fault unpaid_throughput() {
  using Unpaid = RouletteByThroughput<faults::UnpaidRoulette>;
  using Tracer = PathTracer<BouncesBy<CosineHemisphere>, NoDirectLight, Unpaid>;
  const std::vector<Claim> claims{
      mean_claim(roulette_walk<Unpaid, UniformHemisphere>("roulette.walk.throughput", "", 2)),
      mean_claim(furnace_radiance<Tracer>("furnace.throughput", {}))};
  return {"roulette-by-throughput-unpaid", "roulette unpaid", "openmc #3511; chunky #1018", claims};
}

Fault spared_paid() {
  return {"roulette-spared-paid", "roulette unpaid", "none: a slip of the mask",
          both(later_roulette_walk<faults::SparedPaid>())};
}

Fault roulette_late() {
  return {"roulette-a-bounce-late", "roulette out of order", "none: what is carried, before the vertex's albedo",
          both(later_roulette_walk_length<faults::CarriedBefore>())};
}

Fault weights_on_one_side() {
  using Wrong = faults::PowerOnOneSide;
  return {"mis-power-on-one-side", "MIS sum", "mitsuba aa325039f; Moer #59",
          together(together(both(multi_sample_peaks<Wrong>("mis.peaks.power", {})),
                            both(one_sample_peaks<Wrong>("mis.one_sample.power", {}))),
                   both(solid_angle_by_two<Wrong>("mis.hemisphere.power")))};
}

Fault counts_ignored() {
  return {"mis-counts-ignored", "MIS sum", "appleseed #1515",
          both(multi_sample_peaks<faults::CountsIgnored>("mis.peaks.balance", {}))};
}

Fault selection_unpaid() {
  return {"mis-selection-unpaid", "luminaire probability", "LuxCore #68",
          both(one_sample_peaks<faults::SelectionUnpaid>("mis.one_sample.balance", {}))};
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

Fault densities_swapped() {
  return {"mis-densities-swapped", "MIS sum", "three-gpu-pathtracer #847",
          both(solid_angle_by_two<faults::DensitiesSwapped>("mis.hemisphere.power"))};
}

Fault paid_by_mean() {
  return {"roulette-paid-by-mean", "luminaire probability", "ospray #552",
          both(roulette_walk<faults::RoulettePaidByMean, CosineHemisphere>("roulette.walk.reflectance", "", 1))};
}

Fault number_reused() {
  return {"light-number-reused", "reused number", "pbrt-v4 795c619b",
          both(two_dice<faults::OneOfReusingNumbers>("pick.one.dice", {}))};
}

Fault plain_sum() {
  return {"sum-of-floats", "float sum", "ice_halo_sim #380", {long_sum_claim<faults::PlainSum>()}};
}

}  // namespace

std::vector<Fault> combinator_faults() {
  return {unpaid_throughput(), spared_paid(),      roulette_late(),     weights_on_one_side(),
          counts_ignored(),    selection_unpaid(), wrong_sign(),        factor_forgotten(),
          unpaid_splitting(),  half_jitter(),      densities_swapped(), paid_by_mean(),
          number_reused(),     plain_sum()};
}

}  // namespace fairlight

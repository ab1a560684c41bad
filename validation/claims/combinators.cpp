#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/claims/combinations.h>
#include <fairlight/validation/claims/combinator_variances.h>
#include <fairlight/validation/claims/furnace.h>
#include <fairlight/validation/claims/long_sums.h>
#include <fairlight/validation/claims/roulette_walk.h>

namespace fairlight {
namespace {

void add_roulette(std::vector<Claim>& claims) {
  add_mean(claims, roulette_integral<RussianRoulette>("roulette.integral", 0.3));
  add_mean(claims, roulette_walk<RouletteByReflectance<>, CosineHemisphere>("roulette.walk.reflectance",
                                                                            "RouletteByReflectance", 1));
  add_mean(claims, roulette_walk<RouletteByThroughput<>, UniformHemisphere>("roulette.walk.throughput",
                                                                            "RouletteByThroughput", 2));
  add_mean(claims, later_roulette_walk<RouletteFromBounce>());
  add_independent_mean(claims, roulette_walk_length<RouletteByReflectance<>>());
  add_independent_mean(claims, later_roulette_walk_length<RouletteByThroughput<>>());
  using Tracer = PathTracer<BouncesBy<CosineHemisphere>, NoDirectLight, RouletteByThroughput<>>;
  add_independent_mean(
      claims,
      furnace_radiance<Tracer>("furnace.throughput", {"PathTracer", "NoDirectLight", "RouletteByThroughput"}, 2));
}

void add_mis(std::vector<Claim>& claims) {
  add_mean(claims,
           multi_sample_peaks<BalanceHeuristic>("mis.peaks.balance", {"MultiSampleMis", "BalanceHeuristic"}));
  add_mean(claims, multi_sample_peaks<PowerHeuristic>("mis.peaks.power", {"MultiSampleMis", "PowerHeuristic"}));
  add_mean(claims,
           multi_sample_peaks<MaximumHeuristic>("mis.peaks.maximum", {"MultiSampleMis", "MaximumHeuristic"}));
  add_mean(claims,
           one_sample_peaks<BalanceHeuristic>("mis.one_sample.balance", {"OneSampleMis", "BalanceHeuristic"}));
  add_mean(claims, one_sample_peaks<PowerHeuristic>("mis.one_sample.power", {"OneSampleMis", "PowerHeuristic"}));
  add_mean(claims,
           one_sample_peaks<MaximumHeuristic>("mis.one_sample.maximum", {"OneSampleMis", "MaximumHeuristic"}));
  add_mean(claims, solid_angle_by_two<PowerHeuristic>("mis.hemisphere.power"));
}

}  // namespace

void add_combinator_claims(std::vector<Claim>& claims) {
  add_mean(claims, two_dice<AllLights>("pick.all.dice", {"AllLights"}));
  add_mean(claims, two_dice<UniformLightSampler>("pick.one.dice", {"UniformLightSampler", "UniformChoice"}));
  add_roulette(claims);
  add_mean(claims, splitting_integral<Splitting>("splitting.whole", 3));
  add_mean(claims, splitting_integral<Splitting>("splitting.fraction", 2.25));
  add_mean(claims, control_variate_integral<ControlVariate>("control_variate.integral"));
  add_mean(claims, stratified_integral<StratifiedMean>("stratified.integral"));
  add_mis(claims);
  add_mean(claims, nested_peaks("nested.peaks"));
  add_mean(claims, nested_strata("nested.strata"));
  claims.push_back(all_against_one());
  claims.push_back(splitting_variance());
  claims.push_back(control_variate_variance());
  claims.push_back(stratified_mean_variance());
  claims.push_back(long_sum_claim());
}

}  // namespace fairlight

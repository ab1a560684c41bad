#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/claims/combinator_ranges.h>
#include <fairlight/validation/claims/drawn_picks.h>
#include <fairlight/validation/claims/roulette_steps.h>
#include <fairlight/validation/claims/signed_mis.h>

namespace fairlight {
namespace {

using Values = std::vector<double>;

void add_combinators(std::vector<Claim>& claims) {
  add_mean_over(claims, few_runs(),
                [](const Values& v) { return split_polynomials<Splitting, 6>("signed.splitting.few", v); });
  add_mean_over(claims, many_runs(),
                [](const Values& v) { return split_polynomials<Splitting, 2>("signed.splitting.many", v); });
  add_mean_over(claims, survival_probabilities(), [](const Values& v) {
    return rouletted_polynomials<RussianRoulette, 4>("signed.roulette.any", v);
  });
  add_mean_over(claims, grids(),
                [](const Values& v) { return stratified_polynomials<StratifiedMean>("signed.stratified.any", v); });
  add_mean_over(claims, control_factors(), [](const Values& v) {
    return controlled_polynomials<ControlVariate>("signed.control_variate.any", v);
  });
}

template <class Heuristic>
void add_heuristic(std::vector<Claim>& claims, const std::string& name, const std::string& heuristic) {
  add_mean_over(claims, many_draws_ranges(), [=](const Values& v) {
    return polynomials_of_many_draws<Heuristic>("signed.mis." + name, {"MultiSampleMis", heuristic}, v);
  });
  add_mean_over(claims, one_draw_ranges(), [=](const Values& v) {
    return polynomials_of_one_draw<Heuristic>("signed.one_sample." + name, {"OneSampleMis", heuristic}, v);
  });
}

void add_steps(std::vector<Claim>& claims) {
  add_mean_over(claims, roulette_step_ranges("RouletteByReflectance"),
                steps_by_reflectance<RouletteByReflectance<>>);
  add_mean_over(claims, roulette_step_ranges("RouletteByThroughput"), steps_by_throughput<RouletteByThroughput<>>);
  add_mean_over(claims, roulette_step_ranges("RouletteFromBounce"),
                steps_from_fourth_bounce<RouletteByReflectance<>>);
}

void add_picks(std::vector<Claim>& claims) {
  add_mean_over(claims, pick_ranges("PowerChoice"), picks_by_weight<PowerChoice>);
  add_mean_over(claims, pick_ranges("UniformChoice"), picks_by_number);
  add_mean_over(claims, pick_ranges("ContributionChoice"), picks_by_contribution);
  add_mean_over(claims, faint_ranges("PowerChoice"), picks_of_faint_terms<PowerChoice>);
  add_mean_over(claims, faint_ranges("ContributionChoice"), contributions_of_faint_terms);
}

}  // namespace

void add_combinator_domain_claims(std::vector<Claim>& claims) {
  add_combinators(claims);
  add_heuristic<BalanceHeuristic>(claims, "balance", "BalanceHeuristic");
  add_heuristic<PowerHeuristic>(claims, "power", "PowerHeuristic");
  add_heuristic<MaximumHeuristic>(claims, "maximum", "MaximumHeuristic");
  add_steps(claims);
  add_picks(claims);
}

}  // namespace fairlight

#include <fairlight/validation/claims/combinator_ranges.h>
#include <fairlight/validation/claims/drawn_picks.h>
#include <fairlight/validation/claims/roulette_steps.h>
#include <fairlight/validation/claims/signed_mis.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_combinators.h>
#include <fairlight/validation/faults/wrong_signs.h>

namespace fairlight {
namespace {

using Values = std::vector<double>;

// The rows of `make(values)`, in double and in packets.
template <class Make>
std::vector<Claim> over(const std::vector<ParameterRange>& ranges, const Make& make) {
  std::vector<Claim> claims;
  add_mean_over(claims, ranges, make);
  return claims;
}

template <template <class> class Split>
std::vector<Claim> split() {
  return over(few_runs(),
              [](const Values& values) { return split_polynomials<Split, 6>("signed.splitting.few", values); });
}

std::vector<Claim> rouletted() {
  std::vector<Claim> claims = over(survival_probabilities(), [](const Values& values) {
    return rouletted_polynomials<faults::RouletteCappedUnpaid, 4>("signed.roulette.any", values);
  });
  add_mean_over(claims, roulette_step_ranges("RouletteByReflectance"),
                steps_by_reflectance<RouletteByReflectance<faults::RouletteCappedUnpaid>>);
  return claims;
}

template <class Heuristic>
std::vector<Claim> many_draws(const std::string& name) {
  return over(many_draws_ranges(), [=](const Values& values) {
    return polynomials_of_many_draws<Heuristic>("signed.mis." + name, {}, values);
  });
}

}  // namespace

// Faults at ties, at draws of one sign, and at some values of a parameter alone.
std::vector<Fault> combinator_domain_faults() {
  const auto rows = over(grids(), [](const Values& values) {
    return stratified_polynomials<faults::RowsOfColumns>("signed.stratified.any", values);
  });
  return {{"roulette-capped-unpaid", "survival above 1", "practical-path-guiding #3", rouletted()},
          {"splitting-fraction-lost", "roulette unpaid", "none: a number of runs that is rounded",
           split<faults::FractionLost>()},
          {"splitting-negative-draws-cut", "Montelight", "the class of Smerity/montelight-cpp",
           split<faults::NegativeRunsCut>()},
          {"strata-rows-of-columns", "support", "pbrt-v3 #319, a hole in the samples", rows},
          {"mis-each-of-a-tie", "MIS sum", "the class of Moer #59", many_draws<faults::EachOfATie>("maximum")},
          {"mis-twins-counted-once", "MIS sum", "the class of Moer #59",
           many_draws<faults::TwinsCountedOnce>("balance")},
          {"last-light-lost", "lobe selection", "the class of UnitySSPathTracingURP #8",
           over(pick_ranges("PowerChoice"), picks_by_weight<faults::LastLightLost>)},
          {"faint-lights-lost", "lobe selection", "the class of UnitySSPathTracingURP #8",
           over(faint_ranges("PowerChoice"), picks_of_faint_terms<faults::FaintLightsLost>)}};
}

}  // namespace fairlight

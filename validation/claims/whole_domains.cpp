#include <fairlight/estimators/control_variate.h>
#include <fairlight/estimators/splitting.h>
#include <fairlight/estimators/stratification.h>
#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/claims/rendered_variance.h>
#include <fairlight/validation/claims/signed_integrals.h>

namespace fairlight {
namespace {

using Values = std::vector<double>;

void add_signed_integrals(std::vector<Claim>& claims) {
  const auto add = [&](const std::string& component, const std::string& name, const auto& combine) {
    add_mean_over(claims, signed_coefficients(component), [=](const Values& values) {
      return signed_integral("signed." + name, component, values, combine);
    });
  };
  add("Importance", "importance", [](const auto& inner) { return inner; });
  for (const double q : {0.1, 0.7}) {
    add("Rouletted", q < 0.5 ? "roulette.rare" : "roulette",
        [q]<class Inner>(const Inner& inner) { return Rouletted<Inner, RussianRoulette>(inner, q); });
  }
  for (const double k : {0.3, 2.25}) {
    add("Splitting", k < 1 ? "splitting.fraction" : "splitting",
        [k]<class Inner>(const Inner& inner) { return Splitting<Inner>(inner, k); });
  }
  add("StratifiedMean", "stratified",
      []<class Inner>(const Inner& inner) { return StratifiedMean<Inner>(inner, 1, 7); });
  add_mean_over(claims, signed_coefficients("ControlVariate"),
                [](const Values& values) { return signed_control_variate<ControlVariate>(values); });
}

}  // namespace

void add_whole_domain_claims(std::vector<Claim>& claims) {
  add_signed_integrals(claims);
  add_picture_claims(claims);
}

}  // namespace fairlight

#pragma once

#include <fairlight/validation/checks/variances.h>
#include <fairlight/validation/claims/combinations.h>

namespace fairlight {

/// What combinators are for: the variance that they save, in closed form. Their means do not know whether they do.

/// The paper's loaded die and fair one (pick.all.dice), throwing two dice a time: both, of variance 20/9 + 35/12 = 185/36; or twice
/// one of them, doubled and averaged, of variance 21 + 91/6 - (47/6)^2 / 2 = 395/72. One of them is no better at equal cost: what
/// it saves is the cost.
template <class Terms>
VarianceArm dice(const std::string& name, int times) {
  const auto sum = two_dice<Terms>("", {}).draw;
  return independent_draws(
      name, [=](auto& source) { return sum(std::type_identity<double>{}, source); }, 0, 12, times);
}

template <class All = AllLights>
Claim all_against_one() {
  return variance_claim("variance.all_against_one", {"AllLights", "UniformLightSampler"},
                        "elementary; the paper, A.1", 370.0 / 395, 10, dice<All>("throwing both dice", 1),
                        dice<UniformLightSampler>("throwing one of them, twice,", 2));
}

namespace detail {

template <class Estimator>
VarianceArm contender(const std::string& name, const Estimator& estimator) {
  const Bound bound = estimator.bound();
  const double slack = 1e-12 * std::max(std::abs(bound.lower), std::abs(bound.upper));
  return independent_draws(
      name, [=](auto& source) { return estimator.estimate(source); }, bound.lower - slack, bound.upper + slack);
}

}  // namespace detail

/// Combinators on 2 pi z^2, with z uniform in [0,1): Var z^2 = 1/5 - 1/9 = 4/45.
inline VarianceArm one_height_squared() {
  return detail::contender("one run of it", height_squared()(std::type_identity<double>{}));
}
using HeightSquared = decltype(height_squared()(std::type_identity<double>{}));

/// Three runs that know nothing of each other.
template <template <class> class Split = Splitting>
Claim splitting_variance() {
  const Split<HeightSquared> three(height_squared()(std::type_identity<double>{}), 3);
  return variance_claim("variance.splitting", {"Splitting"}, "elementary; Arvo and Kirk 1990", 1.0 / 3, 20,
                        detail::contender("an estimator split in three", three), one_height_squared());
}

/// Less 3/4 of z: Var z = 1/12 and Cov(z^2, z) = 1/4 - 1/6 = 1/12, so 4/45 - 3/2 / 12 + 9/16 / 12 = 31/256 x 4/45.
template <template <class, class> class Variate = ControlVariate>
Claim control_variate_variance() {
  return variance_claim("variance.control_variate", {"ControlVariate"}, "elementary; Hammersley and Handscomb 1964",
                        31.0 / 256, 20,
                        detail::contender("cos^2 with cos for a control",
                                          controlled_height_squared<Variate>()(std::type_identity<double>{})),
                        one_height_squared());
}

/// A grid of 3 by 2, two in each third of z. In third j, z = (j + t) / 3 and Var z^2 = Var(2 j t + t^2) / 81, which is 4/45,
/// 34/45 and 94/45 over 81: the mean of the six has (2/36) (132/45) / 81 = 11/486 x 4/45.
template <template <class> class Strata = StratifiedMean>
Claim stratified_mean_variance() {
  const Strata<HeightSquared> grid(height_squared()(std::type_identity<double>{}), 3, 2);
  return variance_claim("variance.stratified", {"StratifiedMean"}, "elementary; Cochran 1977, chapter 5",
                        11.0 / 486, 20, detail::contender("a grid of 3 by 2", grid), one_height_squared());
}

}  // namespace fairlight

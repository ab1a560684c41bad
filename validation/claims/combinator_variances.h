#pragma once

#include <fairlight/validation/checks/variances.h>
#include <fairlight/validation/claims/combinations.h>

namespace fairlight {

/// The variance that combinators save, in closed form. Tests of their means cannot see it.

/// The loaded die and the fair die of the paper (pick.all.dice), with two throws for each draw.
/// Throwing both has the variance 20/9 + 35/12 = 185/36. Throwing one of them twice, doubled and
/// averaged, has the variance 21 + 91/6 - (47/6)^2 / 2 = 395/72. Picking one is no better at
/// equal cost: it saves cost only.
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
VarianceArm arm(const std::string& name, const Estimator& estimator) {
  const Bound bound = estimator.bound();
  const double slack = 1e-12 * std::max(std::abs(bound.lower), std::abs(bound.upper));
  return independent_draws(
      name, [=](auto& source) { return estimator.estimate(source); }, bound.lower - slack, bound.upper + slack);
}

}  // namespace detail

/// Combinators on 2 pi z^2, with z uniform in [0,1): Var z^2 = 1/5 - 1/9 = 4/45.
inline VarianceArm one_height_squared() {
  return detail::arm("one run of it", height_squared()(std::type_identity<double>{}));
}
using HeightSquared = decltype(height_squared()(std::type_identity<double>{}));

/// Splitting into three independent runs.
template <template <class> class Split = Splitting>
Claim splitting_variance() {
  const Split<HeightSquared> three(height_squared()(std::type_identity<double>{}), 3);
  return variance_claim("variance.splitting", {"Splitting"}, "elementary; Arvo and Kirk 1990", 1.0 / 3, 20,
                        detail::arm("an estimator split in three", three), one_height_squared());
}

/// The control variate 3/4 z. Var z = 1/12 and Cov(z^2, z) = 1/4 - 1/6 = 1/12, so the variance is
/// 4/45 - 3/2 / 12 + 9/16 / 12 = 31/256 x 4/45.
template <template <class, class> class Variate = ControlVariate>
Claim control_variate_variance() {
  return variance_claim("variance.control_variate", {"ControlVariate"}, "elementary; Hammersley and Handscomb 1964",
                        31.0 / 256, 20,
                        detail::arm("cos^2 with cos for a control",
                                    controlled_height_squared<Variate>()(std::type_identity<double>{})),
                        one_height_squared());
}

/// A grid of 3 by 2 strata, two in each third of z. In third j, z = (j + t) / 3 and Var z^2 = Var(2
/// j t + t^2) / 81, which is 4/45, 34/45 and 94/45 over 81. The mean of the six has the variance
/// (2/36) (132/45) / 81 = 11/486 x 4/45.
template <template <class> class Strata = StratifiedMean>
Claim stratified_mean_variance() {
  const Strata<HeightSquared> grid(height_squared()(std::type_identity<double>{}), 3, 2);
  return variance_claim("variance.stratified", {"StratifiedMean"}, "elementary; Cochran 1977, chapter 5",
                        11.0 / 486, 20, detail::arm("a grid of 3 by 2", grid), one_height_squared());
}

}  // namespace fairlight

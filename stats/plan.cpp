#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <fairlight/stats/plan.h>

namespace fairlight {
namespace {

// At the best bet the log wealth of K = n (m/s)^2 draws has mean K/2 and variance K. The test bets
// 0.9 of it, so the mean is (0.9 - 0.9^2 / 2) K and the variance 0.9^2 K.
constexpr double part_of_best_bet = 0.9;
constexpr double drift = part_of_best_bet - part_of_best_bet * part_of_best_bet / 2;

// P(T > k), where T is the time at which a Brownian motion with this drift reaches `level`: the
// inverse Gaussian law.
double still_below(double level, double k) {
  const boost::math::normal normal;
  const double root = part_of_best_bet * std::sqrt(k);
  const double tilt = std::exp(2 * drift * level / (part_of_best_bet * part_of_best_bet));
  return cdf(complement(normal, (drift * k - level) / root)) - tilt * cdf(normal, -(drift * k + level) / root);
}

// P(one of the two wealths is still below 1/beta). The noises of the two are opposite, so that they
// are hardly ever late together, and Bonferroni's bound is nearly the probability.
double one_below(double level, double k) { return std::min(1.0, 2 * still_below(level, k)); }

double k_with(double level, double missing) {
  std::uintmax_t iterations = 200;
  const auto excess = [&](double k) { return one_below(level, k) - missing; };
  double high = 2 * level / drift;
  while (excess(high) > 0) high *= 2;
  const auto near_enough = [](double a, double b) { return b - a < 1e-6 * b; };
  const auto bracket = boost::math::tools::toms748_solve(excess, 1e-3 * level, high, near_enough, iterations);
  return bracket.second;
}

double expected_k(double level) {
  using Rule = boost::math::quadrature::gauss_kronrod<double, 61>;
  const double certain = k_with(level, 0.999999);  // one_below is 1 up to here
  const double end = k_with(level, 1e-12);
  return certain + Rule::integrate([&](double k) { return one_below(level, k); }, certain, end, 10, 1e-6);
}

void check(const MeanPlan& p) {
  if (!(p.beta > 0 && p.beta < 1)) throw std::invalid_argument("the miss rate beta must be in (0,1)");
  if (!(p.scale > 0 && std::isfinite(p.scale)))
    throw std::invalid_argument("the scale of a margin must be positive and finite (the mean is 0: give one)");
  if (!(p.lower < p.mean && p.mean < p.upper && std::isfinite(p.upper - p.lower)))
    throw std::invalid_argument("the mean must lie inside the declared range of the draws");
  if (!(p.deviation >= 0 && p.deviation <= std::sqrt((p.upper - p.mean) * (p.mean - p.lower)) * (1 + 1e-12)))
    throw std::invalid_argument(
        "the standard deviation must be nonnegative, and at most what the range and the mean allow, "
        "sqrt((upper - mean) (mean - lower))");
}

// Where the range limits the bets, each draw multiplies the wealth by 1 + 0.9 m / room; the first
// draws, before the variance is known, cost a tenth more.
double range_draws(const MeanPlan& p, double level) {
  return 1.1 * level / part_of_best_bet * std::max(p.upper - p.mean, p.mean - p.lower);
}

// The positive m with k s^2 / m^2 + r / m = n.
double margin_for(double k, const MeanPlan& p, double range, double n) {
  const double s2 = k * p.deviation * p.deviation;
  return (range + std::sqrt(range * range + 4 * n * s2)) / (2 * n) / p.scale;
}

}  // namespace

PlannedDraws planned_draws(const MeanPlan& plan, double margin) {
  check(plan);
  if (!(margin > 0 && std::isfinite(margin))) throw std::invalid_argument("the margin must be positive and finite");
  const double level = std::log(1 / plan.beta);
  const double m = margin * plan.scale;
  if (!(plan.lower < plan.mean - m && plan.mean + m < plan.upper))
    throw std::invalid_argument("the mean, with its margin, must lie inside the declared range of the draws");
  const double cv2 = std::pow(plan.deviation / m, 2);
  const double range = range_draws(plan, level) / m;
  return {expected_k(level) * cv2 + range, k_with(level, 0.01) * cv2 + range};
}

PlannedMargin planned_margin(const MeanPlan& plan, double draws) {
  check(plan);
  if (!(draws > 0 && std::isfinite(draws)))
    throw std::invalid_argument("the number of draws must be positive and finite");
  const double level = std::log(1 / plan.beta);
  const double range = range_draws(plan, level);
  return {margin_for(expected_k(level), plan, range, draws), margin_for(k_with(level, 0.01), plan, range, draws)};
}

}  // namespace fairlight

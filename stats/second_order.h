#pragma once

#include <functional>
#include <utility>

#include <fairlight/stats/mean_test.h>

namespace fairlight {

/// Claims about variances and correlations, restated as claims about means. For independent X and
/// X' of one law, (X - X')^2 / 2 has the variance of X as its mean, and is bounded when X is. So
/// the core test applies and is exact.

/// An estimator that returns one draw, and the range of its draws.
struct BoundedEstimator {
  std::function<double(std::uint64_t index)> draw;  ///< draw number `index`, independent of the others
  double lower, upper;
};

/// Tests that the variance is `variance` > 0 (or at most, or at least that). The margin is relative
/// to it. Takes two draws of the estimator for each draw that the finding counts.
Finding test_variance(const Trial& trial, double variance, const BoundedEstimator& estimator,
                      Sides sides = Sides::both);

/// Tests that Var A <= ratio Var B; a ratio below 1 shows by how much A is better. Refuted by bets on
/// E[a - ratio b] > 0, certified by bets on E[a - (1 + margin) ratio b] < 0, which is Var A < (1 +
/// margin) ratio Var B: no scale is estimated. Guarantee: exact. Bias and interval are those of
/// Var A / (ratio Var B) - 1, each end wrong with at most 2.5 beta; an interval that reaches 0 is open
/// below. Undecided, with a note, if B shows no variance. Throws std::invalid_argument for a ratio
/// that is not positive.
Finding test_variance_ratio(const Trial& trial, double ratio, const BoundedEstimator& a, const BoundedEstimator& b);

/// Tests that two streams with known means are uncorrelated: E[(A - mean_a)(B - mean_b)] = 0,
/// within margin times `scale`, the product of their standard deviations. `draw(i)` returns pair i.
/// All draws lie within `reach` of their means.
Finding test_uncorrelated(const Trial& trial, std::pair<double, double> means, double reach, double scale,
                          const std::function<std::pair<double, double>(std::uint64_t)>& draw);

}  // namespace fairlight

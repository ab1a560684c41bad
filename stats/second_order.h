#pragma once

#include <functional>
#include <utility>

#include <fairlight/stats/mean_test.h>

namespace fairlight {

/// Claims about variances and correlations, made into claims about means: for independent X and X' of one law,
/// E[(X - X')^2 / 2] is the variance, and it is bounded when X is. The core test then holds exactly.

/// One draw of an estimator, and its range.
struct BoundedEstimator {
  std::function<double(std::uint64_t index)> draw;  ///< draw number `index`, independent of the others
  double lower, upper;
};

/// The variance is `variance` > 0 (or at most, or at least that), to within the margin relative to it. Takes two draws for
/// each draw of the finding.
Finding test_variance(const Trial& trial, double variance, const BoundedEstimator& estimator,
                      Sides sides = Sides::both);

/// Var A <= ratio Var B. Biased when it is larger; certified when Var A < (1 + margin) ratio Var B.
/// With ratio < 1 this shows by how much A is better. A discarded pilot sets the scale of the
/// margin, ratio Var B; the level does not rest on it (what is certified is a difference below
/// margin times that scale). Bias and interval are of Var A / (ratio Var B) - 1, the interval open
/// below where it reaches 0. Throws std::invalid_argument for a ratio that is not positive, or when
/// the pilot shows no variance in B.
Finding test_variance_ratio(const Trial& trial, double ratio, const BoundedEstimator& a, const BoundedEstimator& b);

/// Two streams whose means are known are uncorrelated: E[(A - mean_a)(B - mean_b)] = 0, to within margin times
/// `scale`, the product of their standard deviations. `draw(i)` gives the i-th pair; both lie within `reach` of
/// their means.
Finding test_uncorrelated(const Trial& trial, std::pair<double, double> means, double reach, double scale,
                          const std::function<std::pair<double, double>(std::uint64_t)>& draw);

/// The ratio of two sample variances with an interval each of whose ends is wrong with probability beta,
/// asymptotically, by the delta method from the fourth moments. Throws std::invalid_argument unless both variances
/// are positive.
struct VarianceRatio {
  double ratio;
  Interval interval;
};
VarianceRatio variance_ratio(const Moments& a, const Moments& b, double beta);

}  // namespace fairlight

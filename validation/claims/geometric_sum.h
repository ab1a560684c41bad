#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace fairlight {

/// What a path brings that gathers a term at every vertex and then goes on with the probability `goes_on`, below 1: the terms are
/// from 0 to `largest`, and each has at most the mean `mean`, whatever came before it. Terms and bounds are of one unit.
struct GeometricSum {
  double mean;
  double largest;
  double goes_on;

  /// The least multiple b of the largest term with E[(sum - b)+] <= slack, slack > 0, whatever the terms' law. What is beyond a bound is
  /// convex in every term, and so the most where terms are 0 or the largest, the latter with p = mean / largest. There is one such
  /// with probability a = p / (1 - q (1 - p)), and after each another with q a, where q is `goes_on`; so E[(sum - m largest)+] is largest a (q a)^m / (1 - q a).
  /// Throws std::invalid_argument outside the domains.
  /// Source   Hoeffding 1963, Probability inequalities for sums of bounded random variables, (4.1), for the convexity
  double bound(double slack) const {
    if (!(0 < mean && mean <= largest && 0 < goes_on && goes_on < 1 && slack > 0))
      throw std::invalid_argument("a geometric sum needs 0 < mean <= largest, 0 < goes_on < 1 and slack > 0");
    const double p = mean / largest;
    const double one = p / (1 - goes_on * (1 - p)), another = goes_on * one;
    const double terms = std::log(slack * (1 - another) / (largest * one)) / std::log(another);
    return largest * std::max(std::ceil(terms), 0.0);
  }
};

}  // namespace fairlight

#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace fairlight {

/// The sum of the terms of a path that gathers one at every vertex, and then goes on with the
/// probability `goes_on`, below 1. A term is in [0, `largest`], and its conditional mean is at most
/// `mean`, whatever came before. All in one unit.
struct GeometricSum {
  double mean;
  double largest;
  double goes_on;

  /// The least multiple b of the largest term with E[(sum - b)+] <= slack for any law of the terms,
  /// where slack > 0. Throws std::invalid_argument outside the domains.
  /// Source   Hoeffding 1963, Probability inequalities for sums of bounded random variables, (4.1),
  ///          for the convexity
  double bound(double slack) const {
    // (sum - b)+ is convex in every term, so its mean is largest if terms are 0 or `largest`, the
    // latter with the probability p = mean / largest. With q = goes_on, a path has such a term with
    // the probability a = p / (1 - q (1 - p)), and after each another with q a. So E[(sum - m
    // largest)+] is largest a (q a)^m / (1 - q a).
    if (!(0 < mean && mean <= largest && 0 < goes_on && goes_on < 1 && slack > 0))
      throw std::invalid_argument("a geometric sum needs 0 < mean <= largest, 0 < goes_on < 1 and slack > 0");
    const double p = mean / largest;
    const double one = p / (1 - goes_on * (1 - p)), another = goes_on * one;
    const double terms = std::log(slack * (1 - another) / (largest * one)) / std::log(another);
    return largest * std::max(std::ceil(terms), 0.0);
  }
};

}  // namespace fairlight

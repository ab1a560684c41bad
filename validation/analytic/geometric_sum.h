#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <boost/math/tools/minima.hpp>

namespace fairlight {

/// What a path brings that gathers a term at every vertex and then goes on with the probability `goes_on`, below 1: the terms are
/// from 0 to `largest`, and each has at most the mean `mean`, whatever came before it. Terms and bounds are of one unit.
struct GeometricSum {
  double mean;
  double largest;
  double goes_on;

  /// A bound b with E[(sum - b)+] <= slack, slack > 0: far below that of as many terms of the largest size, as these are rare.
  /// Chernoff's bound at its best rate: (x)+ <= exp(s x) / (e s), and E[exp(s term)] <= 1 + mean (exp(s largest) - 1) / largest, as exp
  /// is convex. Throws std::invalid_argument outside the domains.
  /// Source   Hoeffding 1963, Probability inequalities for sums of bounded random variables, (4.1)
  double bound(double slack) const {
    if (!(0 < mean && mean <= largest && 0 < goes_on && goes_on < 1 && slack > 0))
      throw std::invalid_argument("a geometric sum needs 0 < mean <= largest, 0 < goes_on < 1 and slack > 0");
    const double fastest = std::log1p(largest / mean * (1 / goes_on - 1)) / largest;
    const auto at = [&](double share) { return bound_at(share * fastest, slack); };
    std::uintmax_t iterations = 100;
    constexpr int bits = std::numeric_limits<double>::digits / 2;
    return boost::math::tools::brent_find_minima(at, 0.01, 0.9999, bits, iterations).second;
  }

 private:
  // Any rate below the fastest gives a bound. The transform of the sum solves G = term (1 - goes_on + goes_on G).
  double bound_at(double rate, double slack) const {
    const double term = 1 + mean * std::expm1(rate * largest) / largest;
    const double sum = term * (1 - goes_on) / (1 - goes_on * term);
    return std::log(sum / (rate * std::numbers::e * slack)) / rate;
  }
};

}  // namespace fairlight

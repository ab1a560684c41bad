#pragma once

#include <fairlight/estimators/packet.h>

namespace fairlight {

/// A sum of nonnegative numbers that keeps what each addition rounds off: high + low is the sum of n numbers to (n u)^2 of
/// it, and grows by each to n u^2 of it, u being half an ulp. Here is no product that a compiler could contract with a sum;
/// where `x` is one, it must be a number before: compared, for GCC then contracts none of its uses.
/// Source: Knuth, TAOCP 2, 4.2.2 (the error of a sum is a number); Neumaier 1974.
template <class Real>
struct LongSum {
  Real high = Real(0);
  Real low = Real(0);

  void add(Real x) {
    const Real sum = high + x;
    const Real added = sum - high;
    low += (high - (sum - added)) + (x - added);
    high = sum;
  }

  Real value() const { return high + low; }

  /// Where the difference of two sums is not positive; of near ones, that of the high parts is exact.
  friend Mask<Real> operator<=(const LongSum& a, const LongSum& b) {
    return (a.high - b.high) + (a.low - b.low) <= Real(0);
  }
};

}  // namespace fairlight

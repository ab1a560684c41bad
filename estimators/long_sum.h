#pragma once

#include <fairlight/estimators/packet.h>

namespace fairlight {

/// Compensated sum of nonnegative numbers: `low` collects the rounding error of each addition. With
/// u half an ulp, high + low equals the sum of n numbers to a relative (n u)^2; each addition
/// contributes n u^2. `add` contains no product that a compiler could contract into an FMA. If x is
/// a product, compare it with something first: then GCC contracts none of its uses.
/// Source   Knuth, TAOCP 2, 4.2.2 (the rounding error of a sum is a float); Neumaier 1974
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

  /// Whether a - b is not positive. If a and b are close, the difference of the high parts is
  /// exact.
  friend Mask<Real> operator<=(const LongSum& a, const LongSum& b) {
    return (a.high - b.high) + (a.low - b.low) <= Real(0);
  }
};

}  // namespace fairlight

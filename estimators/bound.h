#pragma once

#include <algorithm>

#include <fairlight/estimators/real.h>

namespace fairlight {

/// A bound on every draw of an estimator, in each channel and in the estimator's unit: lower <=
/// draw <= upper. It holds for real numbers, without rounding. Without a bound no exact test can
/// find that an estimator is too dark: a part of the mean may hide in a tail that is never sampled.
/// The default is no bound.
struct Bound {
  double lower = -infinity<double>;
  double upper = infinity<double>;

  friend bool operator==(const Bound&, const Bound&) = default;
};

/// The bound of the sum of two draws.
inline Bound operator+(const Bound& a, const Bound& b) { return {a.lower + b.lower, a.upper + b.upper}; }

/// The bound of k times a draw. A negative k swaps the ends; 0 times any draw is 0, even an
/// unbounded one.
inline Bound operator*(double k, const Bound& a) {
  if (k == 0) return {0, 0};
  return k > 0 ? Bound{k * a.lower, k * a.upper} : Bound{k * a.upper, k * a.lower};
}

/// The bound of a draw that satisfies one bound or the other.
inline Bound hull(const Bound& a, const Bound& b) {
  return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}

/// The bound of a draw that may also be 0.
inline Bound or_nothing(const Bound& a) { return hull(a, {0, 0}); }

}  // namespace fairlight

#pragma once

#include <algorithm>

#include <fairlight/estimators/real.h>

namespace fairlight {

/// Where every draw of an estimator lies, each channel of it, in the estimator's unit: lower <= draw <= upper. It is
/// said of real numbers; what an arithmetic rounds comes on top. Without a bound "too dark" cannot be tested exactly:
/// a mean may hide in a tail that is never seen. Nothing is known until it is said.
struct Bound {
  double lower = -infinity<double>;
  double upper = infinity<double>;

  friend bool operator==(const Bound&, const Bound&) = default;
};

/// Of the sum of two draws.
inline Bound operator+(const Bound& a, const Bound& b) { return {a.lower + b.lower, a.upper + b.upper}; }

/// Of k times a draw; a negative k exchanges the ends, and 0 times a draw is 0, whatever the draw.
inline Bound operator*(double k, const Bound& a) {
  if (k == 0) return {0, 0};
  return k > 0 ? Bound{k * a.lower, k * a.upper} : Bound{k * a.upper, k * a.lower};
}

/// Of a draw that is one of either.
inline Bound hull(const Bound& a, const Bound& b) {
  return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}

/// Of a draw that may also be nothing.
inline Bound or_nothing(const Bound& a) { return hull(a, {0, 0}); }

}  // namespace fairlight

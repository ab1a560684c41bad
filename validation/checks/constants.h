#pragma once

#include <fairlight/validation/checks/draws.h>

namespace fairlight {

/// Tests an estimator without variance: draws equal the reference to within the relative error
/// `tolerance`. It looks at 102 400 of them, so it certifies all draws but a share of 4.5e-5, at the
/// miss rate 0.01, and no mean: a draw in a million may be anything. The margin and the interval are
/// of the draws that were seen. Guarantee: exact; `biased` is deterministic.
Finding check_constant(const Trial& trial, double reference, double tolerance, const Draws& draws);

/// The same, with the tolerance in units in the last place of a Real. `draw(source)` gives one
/// draw.
template <class Real = double, class Draw>
Finding check_constant(const Trial& trial, double reference, int ulps, const Draw& draw) {
  const auto body = body_of_source<Real>([draw](auto& source) { return draw(source); });
  return check_constant(trial, reference, ulps * static_cast<double>(ulp<Real>), draws_of<Real>(body, 1));
}

}  // namespace fairlight

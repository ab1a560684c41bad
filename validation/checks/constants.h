#pragma once

#include <fairlight/validation/checks/draws.h>

namespace fairlight {

/// Every draw equals the reference to within `tolerance`, relative: an estimator without variance.
Finding check_constant(const Trial& trial, double reference, double tolerance, const Draws& draws);

/// To within so many units in the last place of a Real: `draw(source)` gives one.
template <class Real = double, class Draw>
Finding check_constant(const Trial& trial, double reference, int ulps, const Draw& draw) {
  const auto body = body_of_source<Real>([draw](auto& source) { return draw(source); });
  return check_constant(trial, reference, ulps * static_cast<double>(ulp<Real>), draws_of<Real>(body, 1));
}

}  // namespace fairlight

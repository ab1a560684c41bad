#pragma once

#include <fairlight/estimators/density.h>
#include <fairlight/estimators/vec.h>

namespace fairlight {

/// value / density, an estimate from one draw; 0 if the density is 0, as the sample then does not
/// exist. A negative or NaN density is an error, and shows in the result.
template <class Value, class Measure, class Real>
Value safe_divide(const Value& value, Density<Measure, Real> density) {
  const Mask<Real> exists = density.value() != Real(0);
  return select(exists, Value(value / select(exists, density.value(), Real(1))), zero<Value>());
}

}  // namespace fairlight

#pragma once

#include <fairlight/estimators/density.h>
#include <fairlight/estimators/vec.h>

namespace fairlight {

/// value / density, an estimate from one draw; 0 where the density is 0, as the sample does not exist. A density that is negative
/// or not a number is no such thing: it shows in the result.
template <class Value, class Measure, class Real>
Value safe_divide(const Value& value, Density<Measure, Real> density) {
  const Mask<Real> exists = density.value() != Real(0);
  return select(exists, Value(value / select(exists, density.value(), Real(1))), zero<Value>());
}

}  // namespace fairlight

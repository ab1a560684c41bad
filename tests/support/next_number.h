#pragma once

#include <fairlight/estimators/concepts.h>

namespace fairlight::testing {

/// A simple estimator: `scale` times the next number, in [0, scale).
template <class Real>
struct NextNumber {
  using Scalar = Real;
  double scale = 1;

  template <UniformSource<Real> Source>
  Real estimate(Source& source) const {
    return rounded<Real>(scale) * source.next();
  }
  Bound bound() const { return {0, scale}; }
};

}  // namespace fairlight::testing

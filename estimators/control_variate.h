#pragma once

#include <stdexcept>
#include <type_traits>
#include <utility>

#include <fairlight/estimators/concepts.h>

namespace fairlight {

/// Subtracts c times a control variate of known mean, and adds c times that mean. The mean stays
/// the same, and the variance falls if the two are correlated.
/// Formula  F - c (G - E[G])
/// Domain   F and G take equally many numbers; c and E[G] are finite (else std::invalid_argument)
/// Random   the dimensions of F
/// Bound    F's bound - c (G's bound) + c E[G]; a draw may be negative even if F and G never are
/// Source   Hammersley and Handscomb 1964, 5.5; Glasserman 2003, 4.1 (c and its fit)
template <class Inner, class Control>
class ControlVariate {
  // Both take the same numbers, from a copy of the source. c must be fixed in advance: a c that is
  // fitted to the same draws depends on them, and biases the mean.
 public:
  using Scalar = typename Inner::Scalar;

  ControlVariate(Inner inner, Control control, double c, double control_mean)
      : inner_(std::move(inner)), control_(std::move(control)), c_(c), control_mean_(control_mean) {
    if (!all_finite(c) || !all_finite(control_mean))
      throw std::invalid_argument("a control variate needs a finite factor and a finite mean (both are added)");
  }

  template <UniformSource<Scalar> Source>
  auto estimate(Source& source) const {
    Source same = source;
    using Value = std::remove_cvref_t<decltype(inner_.estimate(source))>;
    const Value difference = control_.estimate(same) - rounded<Scalar>(control_mean_);
    return Value(inner_.estimate(source) - difference * rounded<Scalar>(c_));
  }

  Bound bound() const {
    const double integral = c_ * control_mean_;
    return inner_.bound() + -c_ * control_.bound() + Bound{integral, integral};
  }

 private:
  Inner inner_;
  Control control_;
  double c_, control_mean_;
};

}  // namespace fairlight

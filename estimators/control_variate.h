#pragma once

#include <stdexcept>
#include <type_traits>
#include <utility>

#include <fairlight/estimators/concepts.h>

namespace fairlight {

/// An estimator less c times another whose mean is known, which is added again: the same mean, and less variance where
/// the two go together. Both are fed the same numbers, for which the source is copied. c is fixed in advance: fitted to
/// the draws that it is then used on, it depends on them, and the mean is off.
/// Formula  F - c (G - E[G])
/// Domain   F and G take equally many numbers; c finite and the mean of G finite, or throws std::invalid_argument
/// Random   the dimensions of F
/// Bound    two-sided: F's less c times G's, c E[G] higher; so a draw may be negative where F and G never are
/// Source   Hammersley and Handscomb 1964, section 5.5; Glasserman 2003, section 4.1, for c and its fit
template <class Inner, class Control>
class ControlVariate {
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

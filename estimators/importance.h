#pragma once

#include <utility>

#include <fairlight/estimators/concepts.h>

namespace fairlight {

/// Estimates the integral of f by importance sampling: f(x) / p(x), with x drawn from p. Unbiased
/// if p > 0 wherever f is not 0.
/// Random   two dimensions
/// Bound    inf f/p to sup f/p; the caller states it
/// Source   Kahn and Marshall 1953; the paper, 3.1
template <Sampler Law, class Integrand>
class Importance {
 public:
  using Scalar = typename Law::Scalar;

  Importance(Law law, Integrand integrand, const Bound& bound = {})
      : law_(std::move(law)), integrand_(std::move(integrand)), bound_(bound) {}

  template <UniformSource<Scalar> Source>
  auto estimate(Source& source) const {
    const auto x = law_.sample(next_pair<Scalar>(source));
    return integrand_(x) / law_.pdf(x);
  }

  Bound bound() const { return bound_; }

 private:
  Law law_;
  Integrand integrand_;
  Bound bound_;
};

}  // namespace fairlight

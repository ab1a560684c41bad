#pragma once

#include <utility>

#include <fairlight/estimators/concepts.h>

namespace fairlight {

/// The integral of f by importance sampling: f(x) / p(x) with x drawn from p.
/// Unbiased when p > 0 wherever f is not zero. Bound: sup f/p.
/// Random   two dimensions
/// Source   Kahn and Marshall 1953; the paper, 3.1
template <Sampler Law, class Integrand>
class Importance {
 public:
  Importance(Law law, Integrand integrand) : law_(std::move(law)), integrand_(std::move(integrand)) {}

  template <UniformSource<typename Law::Scalar> Source>
  auto estimate(Source& source) const {
    const auto x = law_.sample(next_pair<typename Law::Scalar>(source));
    return integrand_(x) / law_.pdf(x);
  }

 private:
  Law law_;
  Integrand integrand_;
};

}  // namespace fairlight

#pragma once

#include <cstddef>
#include <vector>

namespace fairlight {

/// A UniformSource of the next n numbers of another, which are taken at once: what comes after a path that ends early then has the
/// same numbers in each arithmetic, though lanes of a packet go on together. std::out_of_range where more are asked for.
template <class Real>
class NumbersAhead {
 public:
  template <class Source>
  static NumbersAhead of(Source& source, std::size_t n) {
    NumbersAhead ahead;
    ahead.numbers_.reserve(n);
    while (ahead.numbers_.size() < n) ahead.numbers_.push_back(source.next());
    return ahead;
  }
  Real next() { return numbers_.at(used_++); }

 private:
  std::vector<Real> numbers_;
  std::size_t used_ = 0;
};

/// An estimator that takes its n numbers at once, as another comes after it. The same bound.
template <class Inner>
struct InStep {
  using Scalar = typename Inner::Scalar;

  Inner inner;
  std::size_t numbers;

  template <class Source>
  auto estimate(Source& source) const {
    auto ahead = NumbersAhead<Scalar>::of(source, numbers);
    return inner.estimate(ahead);
  }
  auto bound() const { return inner.bound(); }
};

}  // namespace fairlight

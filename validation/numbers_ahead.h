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

}  // namespace fairlight

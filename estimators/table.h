#pragma once

#include <vector>

#include <fairlight/estimators/packet.h>

namespace fairlight {

/// A table of numbers that each lane looks up by its own index. The caller keeps indices in range.
template <class Real>
class Table {
 public:
  Table() = default;
  /// Rounds the numbers to Real.
  explicit Table(const std::vector<double>& numbers) : size_(numbers.size()) {
    for (double x : numbers) numbers_.push_back(static_cast<Lane<Real>>(x));
    numbers_.resize((size_ + lanes<Real>) / lanes<Real> * lanes<Real>);
  }

  std::size_t size() const { return size_; }

  Real operator()(const Index<Real>& i) const {
    if constexpr (lanes < Real >> 1) {
      Real found;
      if (detail::look_up(numbers_.data(), size_, i, found)) return found;
    }
    return gather(numbers_.data(), i);
  }

 private:
  std::size_t size_ = 0;
  std::vector<Lane<Real>> numbers_;  // padded with zeros to whole registers
};

}  // namespace fairlight

#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace fairlight {

/// The correlation of each draw with the next. The tests of means assume independent draws.
class LagOne {
 public:
  void add(std::span<const double> draws);

  /// NaN where the draws have no variance, or are not finite.
  double correlation() const;

  /// A sentence where the correlation is beyond 0.05 and beyond six standard errors (1/sqrt(n), of
  /// independent draws); otherwise empty.
  std::string warning() const;

 private:
  std::uint64_t count_ = 0;
  double first_ = 0, last_ = 0;  // draws are counted from the first, which keeps their digits
  double sum_ = 0, squares_ = 0, products_ = 0;
};

}  // namespace fairlight

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

  /// A sentence where the correlation is beyond 0.05 and beyond six standard errors; otherwise
  /// empty. The standard error is that of the products themselves, so that a few large draws side
  /// by side, as rare draws may be by chance, are no warning.
  std::string warning() const;

 private:
  std::uint64_t count_ = 0;
  double mean_ = 0, last_ = 0;
  double squares_ = 0, products_ = 0, squared_products_ = 0;  // of deviations from the mean so far
};

}  // namespace fairlight

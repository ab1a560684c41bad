#pragma once

#include <cstdint>
#include <span>

namespace fairlight {

/// Count, mean and sum of squared deviations of a sample, stable and mergeable.
/// A block is summed in two passes and merged pairwise. Source: Chan, Golub, LeVeque 1979.
class Moments {
 public:
  /// The moments of one block of draws.
  static Moments of(std::span<const double> draws);

  void merge(const Moments& other);

  std::uint64_t count() const { return count_; }
  /// The mean; 0 before the first draw.
  double mean() const { return mean_; }
  /// Sum of squared deviations from the mean.
  double squared_deviations() const { return squares_; }
  /// The unbiased variance. Throws std::logic_error with fewer than two draws.
  double variance() const;

 private:
  std::uint64_t count_ = 0;
  double mean_ = 0;
  double squares_ = 0;
};

}  // namespace fairlight

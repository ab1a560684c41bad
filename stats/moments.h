#pragma once

#include <cstdint>
#include <limits>
#include <span>

namespace fairlight {

/// The count, extremes and central moments up to the fourth of a sample. Merging in a fixed order
/// gives the same bits, whichever threads computed the parts. When parts of similar size are
/// merged, the relative rounding error grows with the logarithm of the count, so 10^12 draws are no
/// problem.
/// Formula  pairwise update of sums of powers of deviations from the mean
/// Source   Chan, Golub, LeVeque 1979; Pebay 2008, "Formulas for robust, one-pass parallel
/// computation"
class Moments {
 public:
  /// The moments of one block of draws, about its mean. NaNs and infinities propagate to the
  /// results.
  static Moments of(std::span<const double> draws);

  void merge(const Moments& other);

  std::uint64_t count() const { return count_; }
  /// The mean; 0 before the first draw.
  double mean() const { return mean_; }
  /// The smallest and the largest draw; +infinity and -infinity before the first.
  double minimum() const { return minimum_; }
  double maximum() const { return maximum_; }
  /// The sum of squared deviations from the mean.
  double squared_deviations() const { return m2_; }
  /// The sum of cubed deviations from the mean.
  double cubed_deviations() const { return m3_; }

  /// The unbiased variance of one draw. Throws std::logic_error with fewer than two draws.
  double variance() const;
  /// sqrt(variance / count). Throws as variance does.
  double standard_error() const;
  /// g1 = m3 / m2^(3/2), 0 where all draws are equal. Throws std::logic_error without draws.
  double skewness() const;
  /// The relative variance of the variance of the mean, sum d^4 / (sum d^2)^2 - 1/n; 0 where all
  /// draws are equal. Below 0.1 the standard error can be trusted. Source: Estes and Cashwell 1978
  /// (as in MCNP).
  double variance_of_variance() const;

 private:
  void add_mean(std::span<const double> draws);
  void add_powers(std::span<const double> draws);

  std::uint64_t count_ = 0;
  double mean_ = 0;
  double m2_ = 0;
  double m3_ = 0;
  double m4_ = 0;
  double minimum_ = std::numeric_limits<double>::infinity();
  double maximum_ = -std::numeric_limits<double>::infinity();
};

}  // namespace fairlight

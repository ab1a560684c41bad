#pragma once

#include <cstdint>
#include <limits>
#include <span>

namespace fairlight {

/// Count, extremes and central moments up to the fourth of a sample: stable, and mergeable. Merging in a fixed order
/// gives the same bits whatever computed the parts; relative rounding grows with the logarithm of the count when parts
/// of like size are merged, so 10^12 draws are nothing special.
/// Formula  pairwise update of sums of powers of deviations from the mean
/// Source   Chan, Golub, LeVeque 1979; Pebay 2008, "Formulas for robust, one-pass parallel computation"
class Moments {
 public:
  /// The moments of one block of draws, from its mean. Not-a-numbers and infinities go through to the results.
  static Moments of(std::span<const double> draws);

  void merge(const Moments& other);

  std::uint64_t count() const { return count_; }
  /// The mean; 0 before the first draw.
  double mean() const { return mean_; }
  /// The least and the greatest draw; +infinity and -infinity before the first.
  double minimum() const { return minimum_; }
  double maximum() const { return maximum_; }
  /// Sum of squared deviations from the mean.
  double squared_deviations() const { return m2_; }
  /// Sum of their cubes.
  double cubed_deviations() const { return m3_; }

  /// The unbiased variance of one draw. Throws std::logic_error with fewer than two draws.
  double variance() const;
  /// sqrt(variance / count). Throws as variance does.
  double standard_error() const;
  /// g1 = m3 / m2^(3/2), 0 where all draws are equal. Throws std::logic_error before the first draw.
  double skewness() const;
  /// m4 / m2^2, which is 3 for a normal law; 0 where all draws are equal. Throws as skewness does.
  double kurtosis() const;
  /// The relative variance of the variance of the mean, sum d^4 / (sum d^2)^2 - 1/n; below 0.1 where the standard
  /// error can be trusted. 0 where all draws are equal. Source: Estes and Cashwell 1978 (as in MCNP).
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

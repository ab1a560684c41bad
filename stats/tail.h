#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fairlight {

/// The largest draws of a sample, by absolute value, and what they say of its tail. A mean whose variance is
/// infinite, or lies in draws too rare to have been seen, cannot be judged by a normal law; this is how it shows.
class LargestScores {
 public:
  explicit LargestScores(std::size_t keep = 200);

  void add(std::span<const double> draws);

  /// The exponent s of a density that falls like x^-s, by Hill's estimator from the scores kept: above 3 the
  /// variance is finite. Infinity where there is no tail to speak of: fewer than 25 scores, or all alike. Source:
  /// Hill 1975; MCNP's tenth test (Forster, Booth, Pederson 1992) asks for 3 as well.
  double slope() const;

 private:
  std::size_t keep_;
  std::vector<double> heap_;  // a heap with its least score on top
};

/// 1 / (R^2 T): draws per second worth having, with R the standard error relative to the mean and T the time in
/// seconds. Constant for an estimator in good health. Throws std::invalid_argument unless all three are positive.
double figure_of_merit(double mean, double standard_error, double seconds);

}  // namespace fairlight

#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fairlight {

/// The largest draws of a sample, by absolute value. They show whether the tail is too heavy for a
/// normal law: a mean with infinite variance, or with its mass in draws too rare to have been met,
/// cannot be tested by one.
class LargestScores {
 public:
  explicit LargestScores(std::size_t keep = 200);

  void add(std::span<const double> draws);

  /// The exponent s of a density that falls like x^-s, by Hill's estimator from the kept scores;
  /// the variance is finite for s > 3. Infinity for fewer than 25 scores or for equal ones. Source:
  /// Hill 1975; MCNP's tenth test (Forster, Booth, Pederson 1992) also requires s > 3.
  double slope() const { return slope(keep_); }
  /// The same from the `k` largest of these alone.
  double slope(std::size_t k) const;

 private:
  std::size_t keep_;
  std::vector<double> heap_;  // a heap with the smallest score on top
};

}  // namespace fairlight

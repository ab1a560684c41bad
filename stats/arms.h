#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <fairlight/stats/moments.h>
#include <fairlight/stats/tail.h>

namespace fairlight {

/// The samples of one estimator, or of two whose difference is tested: what Student's test (one
/// arm) and Welch's (two) need to know of them, and whether their laws allow such a test.
class Arms {
 public:
  explicit Arms(std::size_t arms) : moments_(arms), scores_(arms) {}

  /// Adds draws of one arm. Throws BadDraw, with `first` as the number of the first of these draws,
  /// for a NaN or an infinity.
  void add(std::size_t arm, std::uint64_t first, std::span<const double> draws);

  std::size_t size() const { return moments_.size(); }
  std::uint64_t count() const { return moments_[0].count(); }  ///< of one arm; all have as many

  /// The mean of the first arm, minus that of the second if there is one.
  double difference() const;
  /// The squared standard error of difference(), with that of each arm from its own variance.
  double squared_error() const;
  /// The degrees of freedom, after Welch and Satterthwaite; n - 1 for one arm.
  double degrees() const;
  /// The skewness of the standardised difference, as if the arms' skewnesses never cancelled.
  double skewness_of_mean() const;
  /// The largest relative variance of a variance; see Moments::variance_of_variance.
  double variance_of_variance() const;
  /// Whether the tail of an arm falls too slowly for a finite variance, by its 200 largest draws and
  /// by its 50 largest: rare draws of one size among small ones look so to the 200 alone.
  bool heavy() const;
  /// Whether the draws of each arm agree to the rounding of numbers as large as `scale`.
  bool constant(double scale) const;

 private:
  std::vector<Moments> moments_;
  std::vector<LargestScores> scores_;
};

}  // namespace fairlight

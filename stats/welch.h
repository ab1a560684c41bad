#pragma once

#include <fairlight/stats/verdict.h>

namespace fairlight {

/// The mean of one sample, and how well it is known: the estimated square of its standard error,
/// with so many degrees of freedom. `skewness` is that of the mean's law, 0 if it is normal.
struct EstimatedMean {
  double mean = 0;
  double squared_error = 0;
  double degrees = 0;
  double skewness = 0;
};

/// Student's test of the difference of two means whose variances differ, at a level that holds for
/// normal draws whatever the ratio of the variances. Welch's degrees of freedom are an
/// approximation; so the nominal level is reduced until the true one, by quadrature over the ratio
/// of the estimated variances, is `level` at the worst ratio. Degrees of freedom above 200 count as
/// 200.
/// Source   Welch 1947; Mickey and Brown 1966 (how far the approximation is off)
class WelchTest {
 public:
  /// Throws std::invalid_argument unless level is in (0, 0.5) and both degrees are at least 1.
  WelchTest(double level, double degrees_a, double degrees_b);

  /// The level of the two-sided test of Welch that has the true level `level`.
  double nominal_level() const { return nominal_; }

  /// How many standard errors the difference may be away from 0, either way, by chance.
  double quantile(const EstimatedMean& a, const EstimatedMean& b) const;

  /// The p-value of mean a - mean b = 0, two-sided, for differences beyond `rounding`. It is
  /// corrected for the ratio of the variances, and for skewness by Hall's factor exp(g x^3 / 3). It
  /// is 1 where nothing varies and the means differ by no more than `rounding`, and 0 where nothing
  /// varies and they do.
  /// Source   Hall 1992
  double p_value(const EstimatedMean& a, const EstimatedMean& b, double rounding = 0) const;

 private:
  double level_, nominal_;
};

/// The level of Welch's two-sided test of this nominal level, for normal draws, where the mean of a
/// has the part `share` of the variance of the difference.
double true_level_of_welch(double nominal, double degrees_a, double degrees_b, double share);

/// The skewness of the law of mean a - mean b, as if those of the two never cancelled.
double skewness_of_difference(const EstimatedMean& a, const EstimatedMean& b);

}  // namespace fairlight

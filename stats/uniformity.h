#pragma once

#include <span>

#include <fairlight/stats/verdict.h>

namespace fairlight {

/// Whether the p-values of right code are uniform on [0,1]. Only then is a test's level true: a
/// wrong sigma, a wrong number of degrees of freedom or a correlation shows here long before it
/// shows as false alarms. Three statistics, each with a third of alpha and both tails: Fisher's -2
/// sum ln p and -2 sum ln(1-p), chi-square with 2n degrees of freedom, for too many small or large
/// p-values; and the Kolmogorov-Smirnov distance.
struct Uniformity {
  double fisher_small;  ///< p-value of -2 sum ln p, two-sided
  double fisher_large;  ///< p-value of -2 sum ln(1-p), two-sided
  /// The p-value of the Kolmogorov-Smirnov distance, upper tail.
  double distance;
  bool uniform;  ///< none of the three p-values is below alpha / 3
};

/// Sorts the p-values in place. Throws std::invalid_argument for an empty span or for a p-value
/// outside (0,1). Source: Fisher 1932; Massart 1990.
Uniformity uniformity(std::span<double> p_values, double alpha);

}  // namespace fairlight

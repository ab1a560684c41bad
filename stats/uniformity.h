#pragma once

#include <span>

#include <fairlight/stats/verdict.h>

namespace fairlight {

/// Whether p-values of right code are uniform on [0,1], which is what makes a test's level true: a wrong sigma, a
/// wrong count of degrees of freedom or a correlation all show here, long before they show as false alarms. Three
/// statistics, each with a third of alpha and both tails: Fisher's -2 sum ln p and -2 sum ln(1-p), chi-square with
/// 2n degrees of freedom, for an excess of small or of large p-values, and the distance of Kolmogorov and Smirnov.
struct Uniformity {
  double fisher_small;  ///< p-value of -2 sum ln p, two-sided
  double fisher_large;  ///< p-value of -2 sum ln(1-p), two-sided
  double distance;      ///< p-value of the greatest distance, from above
  bool uniform;         ///< none is below its third of alpha
};

/// Sorts the p-values in place. Throws std::invalid_argument for none, or for one outside (0,1).
/// Source: Fisher 1932; Massart 1990.
Uniformity uniformity(std::span<double> p_values, double alpha);

}  // namespace fairlight

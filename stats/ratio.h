#pragma once

#include <span>

#include <fairlight/stats/verdict.h>

namespace fairlight {

/// A measured value and its confidence interval. An end is infinite where the data set no bound.
struct Measured {
  double value;
  Interval interval;
};

/// The mean of independent replicates, with Student's t interval at the two-sided `confidence`.
/// Exact for normal replicates; for others asymptotic in their number. Throws std::invalid_argument
/// for fewer than two replicates or a confidence outside (0, 1).
Measured measured_mean(std::span<const double> replicates, double confidence = 0.95);

/// E[A] / E[B] from independent pairs (a_i, b_i), with Fieller's interval. The two values of a pair
/// may depend on each other. Exact if pairs are jointly normal; else asymptotic in their number.
/// The interval is the whole line where the mean of B does not differ from 0 at that confidence.
/// Throws as measured_mean does, and for a different number of values.
/// Source   Fieller 1954, "Some problems in interval estimation"
Measured measured_ratio(std::span<const double> a, std::span<const double> b, double confidence = 0.95);

}  // namespace fairlight

#pragma once

namespace fairlight {

/// What a test of a mean by betting is planned for: right code, whose draws have this standard
/// deviation. All in the draws' unit, except the margin, which is divided by `scale`.
struct MeanPlan {
  double mean, lower, upper;
  double deviation;    ///< standard deviation of one draw
  double scale;        ///< what the margin is relative to; mostly |mean|
  double beta = 0.01;  ///< miss rate
};

/// A number of draws: that which is enough with the given probability, and the expected one.
struct PlannedDraws {
  double expected;
  double with_99_percent;
};

/// How many draws test_means takes on right code to certify a relative margin.
/// Formula  k (deviation / m)^2 + 1.22 log(1/beta) room / m, with m = margin scale, room the larger
/// distance of the mean to an end of the range, and k the (expected, or 99th percentile of the) time
/// at which both certifying wealths, Brownian motions with drift, have reached 1/beta
/// Throws std::invalid_argument unless lower < mean < upper, scale and margin are positive and
/// finite, beta is in (0,1), and 0 <= deviation <= sqrt((upper - mean) (mean - lower)).
/// Source   Bhatia and Davis 2000 for the largest deviation; Wald 1947 for the law of the time
PlannedDraws planned_draws(const MeanPlan& plan, double margin);

/// A relative margin: the one that is certified with 99 % probability by so many draws, and the one
/// whose expected number of draws it is.
struct PlannedMargin {
  double expected;
  double with_99_percent;
};

/// The margins that so many draws certify: the inverse of planned_draws. Throws
/// std::invalid_argument as planned_draws does, and unless `draws` is positive and finite.
PlannedMargin planned_margin(const MeanPlan& plan, double draws);

}  // namespace fairlight

#pragma once

namespace fairlight {

/// The mean of one sample, and how well it is known: the estimated square of its standard error,
/// with so many degrees of freedom. `skewness` is that of the mean's law, 0 if it is normal.
struct EstimatedMean {
  double mean = 0;
  double squared_error = 0;
  double degrees = 0;
  double skewness = 0;
};

/// Student's test of the difference of two means of unequal variance, by Welch's statistic with the
/// smaller of the two degrees of freedom. Welch's own degrees of freedom are an approximation for
/// levels near 0.05; far out in the tail they are much too many. With the smaller, the level holds
/// for normal draws whatever the ratio of the variances, and at levels below 0.08 also where the
/// draws of one sample have unequal variances. Skewness is corrected to first order.
/// Source   Welch 1938; Mickey and Brown 1966; Bakirov and Szekely 2006, Ibragimov and Muller 2016

/// How many standard errors the difference of the means may be away from its expectation, either
/// way; by chance more with probability `level`. Source of the skewness term: Johnson 1978.
double welch_quantile(double level, const EstimatedMean& a, const EstimatedMean& b);

/// The two-sided p-value of mean a = mean b, for the part of the difference beyond `rounding`. The
/// normal tail is multiplied by Hall's factor exp(g x^3 / 3), g the skewness. It is 1 where nothing
/// varies and the means differ by at most `rounding`, and 0 where nothing varies and they differ by
/// more. Source: Hall 1992
double welch_p_value(const EstimatedMean& a, const EstimatedMean& b, double rounding = 0);

/// The same for positive means, by the logarithm of their ratio: a lognormal law, of skewness 3
/// sqrt(squared_error) / mean, then costs nothing, and only a larger skewness is corrected. For
/// means that are not positive it is welch_p_value.
double welch_log_p_value(const EstimatedMean& a, const EstimatedMean& b, double rounding = 0);

/// The skewness of the law of mean a - mean b, as if those of the two never cancelled.
double skewness_of_difference(const EstimatedMean& a, const EstimatedMean& b);

}  // namespace fairlight

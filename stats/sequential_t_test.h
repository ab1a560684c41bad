#pragma once

#include <fairlight/stats/mean_test.h>

namespace fairlight {

/// For estimators without a bound: "too dark" cannot be tested exactly without one, since any mass may hide in a
/// tail that no sample has met. A group-sequential Student test, valid in the limit of many draws.
///
/// A discarded pilot of 4096 draws fixes the looks: six, at 1/4, 1/3, 1/2, 2/3, 5/6 and all of K (s / margin)^2 draws, K
/// chosen so that right code is undecided at the last with probability alpha/50, as far as the pilot can tell. Each look spends
/// alpha f^3 and beta f in steps (Kim and DeMets 1987), added up by Bonferroni. At a look, biased when |t| is beyond the
/// quantile of what it spends; certified when the bias, and beyond it the quantile of what it spends of beta, lie within
/// the margin.
///
/// A look decides only where Student's law can be trusted at its level: with x the normal quantile there and g the
/// skewness, n >= (g x^3 / (3 ln 1.5))^2 keeps the tail within a factor of 1.5; and the largest scores must fall
/// faster than x^-3. Where this fails at the last look, the verdict is undecided and the note says that it is the
/// tail.
///
/// Guarantee: asymptotic. Where all draws agree to rounding the verdict is undecided: the mean may lie in draws too rare to
/// have been met. An estimator that is constant is tested by comparing every draw, or by its range.
/// Source: Pocock 1977; Lan and DeMets 1983; Hall 1992 for the skewness of the studentised mean.
///
/// `draw_block` fills one channel. The reference's bounds are not used; margin and bias are relative to `scale`.
/// Throws std::invalid_argument unless the scale is positive and finite.
Finding sequential_t_test(const Trial& trial, double mean, double scale, const DrawBlock& draw_block);

/// The same for two estimators that should have one mean, by Welch's statistic; `draw_block` fills two channels, a
/// and b, and the bias is that of a against b, relative to `scale`. Source: Welch 1947.
Finding sequential_welch_test(const Trial& trial, double scale, const DrawBlock& draw_block);

}  // namespace fairlight

#pragma once

#include <fairlight/stats/mean_test.h>

namespace fairlight {

/// A group-sequential Student test, for estimators without a bound. Without one, no exact test can
/// detect a mean below the reference: any mass may hide in a tail that no draw has met. Six looks,
/// fixed by a discarded pilot, spend alpha and beta in steps (Lan and DeMets 1983; Kim and DeMets
/// 1987). A look decides only where the skewness and the largest draws show that Student's law
/// holds at its level; otherwise the note says that the tail is at fault. Guarantee: asymptotic.
/// `draw_block` fills one channel. Margin and bias are relative to `scale`. Throws
/// std::invalid_argument unless the scale is positive and finite. See docs/statistics.md,
/// "Student's test".
Finding sequential_t_test(const Trial& trial, double mean, double scale, const DrawBlock& draw_block);

/// Tests that two estimators have the same mean, by Welch's statistic. `draw_block` fills two
/// channels, a and b; the bias is mean a - mean b, divided by `scale`. Source: Welch 1947.
Finding sequential_welch_test(const Trial& trial, double scale, const DrawBlock& draw_block);

}  // namespace fairlight

#pragma once

#include <limits>

#include <fairlight/stats/mean_test.h>

namespace fairlight {

/// A mean whose draws have no declared range, or a range with one end.
struct UnboundedMean {
  double mean;
  double scale;  ///< what margin and bias are divided by; positive and finite
  Sides sides = Sides::both;
  double lower = -std::numeric_limits<double>::infinity();  ///< no draw is below it
  double upper = std::numeric_limits<double>::infinity();   ///< no draw is above it
};

/// A group-sequential Student test, for estimators without a range. A pilot that goes on until it
/// has met the rare draws that it can find fixes six looks, which spend beta in steps (Lan and
/// DeMets 1983). A look certifies only where the skewness and the largest draws show that Student's
/// law holds at its level: asymptotic. Any mass may hide in a tail that no draw has met, so no
/// number of draws shows a bias: the verdict is then undecided, and the note says what to declare.
/// With one end of the range, a mean on the far side of it is `biased` exactly, by betting. Throws
/// std::invalid_argument for a scale that is not positive and finite, or a margin beyond reach.
Finding sequential_t_test(const Trial& trial, const UnboundedMean& claim, const DrawBlock& draw_block);
inline Finding sequential_t_test(const Trial& trial, double mean, double scale, const DrawBlock& draw_block) {
  return sequential_t_test(trial, UnboundedMean{mean, scale}, draw_block);
}

/// Tests that two estimators have the same mean, by Welch's statistic. `draw_block` fills two
/// channels, a and b; the bias is mean a - mean b, divided by `scale`. Source: Welch 1947.
Finding sequential_welch_test(const Trial& trial, double scale, const DrawBlock& draw_block);

}  // namespace fairlight

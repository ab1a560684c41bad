#pragma once

#include <fairlight/stats/mean_test.h>

namespace fairlight {

/// A mean whose draws have no range, but a variance of at most `variance`, positive and finite.
struct FiniteVariance {
  double mean;
  double variance;  ///< in the squared unit of the draws
};

/// A sequential test of a mean by Catoni's influence function, for draws of finite variance.
/// Formula  U = prod exp(phi(l (X - c))) / (1 + l^2 V / 2),  D = prod exp(-phi(l (X - c))) / (same),
///          phi(x) = sign(x) log(1 + |x| + x^2 / 2), for means X of blocks of draws and V theirs
/// `biased` and `certified` as by BettingTest, at its cost with V for the variance. Also biased when
/// the squares of X - mean show that V is too small. Guarantee: exact, given the variance, by
/// Ville's inequality. Margin and bias are relative to `scale`. Throws std::invalid_argument for a
/// mean, variance or scale that is not finite, or not positive where it must be.
/// Source   Catoni 2012; Wang and Ramdas 2023, "Catoni-style confidence sequences for heavy-tailed
///          mean estimation"
Finding catoni_test(const Trial& trial, const FiniteVariance& claim, double scale, const DrawBlock& draw_block);

}  // namespace fairlight

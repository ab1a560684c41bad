#pragma once

#include <cstdint>
#include <span>

namespace fairlight {

/// Rare outcomes, of which too few are expected for chi-square: each has a binomial law.

/// The tails of a cell's binomial law: the probabilities of at most and of at least `count` draws
/// in it. Both are 1 for a cell of probability 0 without draws.
struct CellTails {
  double too_few, too_many;
};
CellTails cell_tails(std::uint64_t count, double draws, double probability);

/// The largest deviation |q - p| / sqrt(max(p, 1e-7)) of an outcome's probability q from p.
struct OutcomeBounds {
  double estimate;   ///< with q = count / draws
  double deviation;  ///< an upper bound for all outcomes together, wrong with probability at most beta
};

/// Bounds the outcomes that expect fewer than 80 draws, or `all` of them. Source: Clopper and
/// Pearson 1934, at beta / (2 outcomes) for each end.
OutcomeBounds bound_rare_outcomes(std::span<const std::uint64_t> counts, std::span<const double> probabilities,
                                  double draws, double beta, bool all);

/// The number of draws, at least `draws`, at which each outcome of a right law can be bounded by the
/// margin, and each that is not rarer than 1e-7 expects eight.
double draws_for_outcomes(std::span<const double> probabilities, double margin, double draws);

}  // namespace fairlight

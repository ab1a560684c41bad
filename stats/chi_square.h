#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include <fairlight/stats/verdict.h>

namespace fairlight {

/// Pearson's statistic with its two tail probabilities. Each tail is computed directly, not as 1
/// minus the other, so small values keep their digits.
struct ChiSquare {
  double statistic;
  double degrees;   ///< degrees of freedom: cells after pooling, less one
  double too_far;   ///< P(chi-square >= statistic): small when the counts do not follow the probabilities
  double too_near;  ///< P(chi-square <= statistic): small when the counts fit too well
};

/// Thrown when there are too few draws for the statistic to follow a chi-square law.
class TooFewDraws : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Compares counts with probabilities. Pools neighbouring cells until each expects at least 80
/// draws: with the customary 5 the tail at 1e-6 is 5.7 times too heavy.
/// Throws std::invalid_argument when the sizes differ, a probability is negative or not finite, the
/// probabilities do not sum to 1 within 1e-6, or a cell of probability 0 has draws. Throws
/// TooFewDraws when fewer than two cells are left after pooling.
/// Source   Pearson 1900; Cochran 1952 for the pooling
ChiSquare chi_square(std::span<const std::uint64_t> counts, std::span<const double> probabilities);

/// The groups into which chi_square pools the cells at this number of draws: for each group, the
/// index after its last cell. Empty when no group reaches 80 expected draws.
std::vector<std::size_t> ends_of_groups(std::span<const double> probabilities, double draws);

/// The number of draws that separates the right law from every law at relative L2 distance
/// `distance` or more, sqrt(sum (q_i - p_i)^2 / p_i), at level alpha (both tails) and miss rate
/// beta.
/// Source   the statistic's noncentral chi-square law, noncentrality n distance^2 (Cohen 1988, ch.
/// 7)
std::uint64_t draws_to_tell_apart(std::uint64_t cells, double distance, double alpha, double beta);

/// The verdict at a fixed number of draws. Biased when a tail is below alpha/2; the lower tail
/// counts only with ten or more degrees of freedom. Certified when a law at `distance` would give a
/// statistic this small with probability at most beta. Otherwise undecided. Guarantee: asymptotic.
Verdict judge(const ChiSquare& result, std::uint64_t draws, double distance, double alpha, double beta);

}  // namespace fairlight

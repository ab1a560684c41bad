#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include <fairlight/stats/verdict.h>

namespace fairlight {

/// Pearson's statistic with its tails, each computed directly and never as one minus the other.
struct ChiSquare {
  double statistic;
  double degrees;   ///< of freedom: cells after pooling, less one
  double too_far;   ///< P(chi-square >= statistic): small when the counts do not follow the probabilities
  double too_near;  ///< P(chi-square <= statistic): small when they follow them better than chance allows
};

/// There are too few draws for a chi-square statistic to have its law.
class TooFewDraws : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Counts against probabilities. Neighbouring cells are pooled until each expects at least 80 draws: with the
/// customary 5 the tail at 1e-6 is 5.7 times too heavy.
/// Throws std::invalid_argument when sizes differ, a probability is negative or not finite, they do not sum to one
/// within 1e-6, or a cell of probability zero was hit; TooFewDraws when fewer than two
/// cells are left.
/// Source: Pearson 1900; Cochran 1952 for the pooling.
ChiSquare chi_square(std::span<const std::uint64_t> counts, std::span<const double> probabilities);

/// Where the groups end, each after its last cell, that cells are pooled into where so many draws are counted. Empty where there is
/// not even one.
std::vector<std::size_t> ends_of_groups(std::span<const double> probabilities, double draws);

/// The number of draws that separates the right law from every law at relative L2 distance `distance` or more,
/// sqrt(sum (q_i - p_i)^2 / p_i), at level alpha (both tails) and miss rate beta.
/// Source: the noncentral chi-square law of the statistic, with noncentrality n distance^2 (Cohen 1988, chapter 7).
std::uint64_t draws_to_tell_apart(std::uint64_t cells, double distance, double alpha, double beta);

/// The verdict at fixed n: biased when either tail is below alpha/2 (the lower only from ten
/// degrees of freedom up); certified when a law at `distance` would have
/// come this near with probability at most beta; undecided between. Guarantee: asymptotic.
Verdict judge(const ChiSquare& result, std::uint64_t draws, double distance, double alpha, double beta);

}  // namespace fairlight

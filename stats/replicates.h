#pragma once

#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include <fairlight/stats/mean_test.h>
#include <fairlight/stats/sequential_t_test.h>

namespace fairlight {

/// For estimators whose draws depend on each other: points of a low-discrepancy set, strata,
/// adaptive stages, states of a Markov chain. One independent replicate, made with its own random
/// numbers, counts as one draw. `replicate(r)` returns the estimate of replicate r, a function of r
/// and the seed alone.

/// Tests the mean of replicates with a declared range, by test_means. Guarantee: exact.
template <class Replicate>
Finding test_replicates(const Trial& trial, const Reference& reference, Replicate&& replicate) {
  return test_means(trial, {reference}, [&](std::uint64_t first, std::vector<std::vector<double>>& channels) {
    for (std::size_t i = 0; i < channels[0].size(); ++i) channels[0][i] = replicate(first + i);
  });
}

/// The same without a range, by Student's test. Guarantee: asymptotic.
template <class Replicate>
Finding test_replicates(const Trial& trial, double mean, Replicate&& replicate) {
  return sequential_t_test(trial, mean, std::abs(mean),
                           [&](std::uint64_t first, std::vector<std::vector<double>>& channels) {
                             for (std::size_t i = 0; i < channels[0].size(); ++i)
                               channels[0][i] = replicate(first + i);
                           });
}

/// The exponent e of variance ~ n^-e, by least squares on logarithms: 1 for independent draws, up
/// to 3 for scrambled nets on smooth integrands. Takes pairs of (points per replicate, variance
/// between replicates). Throws std::invalid_argument for fewer than two pairs, or for a number that
/// is not positive.
double convergence_exponent(std::span<const std::pair<double, double>> variances);

}  // namespace fairlight

#pragma once

#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include <fairlight/stats/mean_test.h>
#include <fairlight/stats/sequential_t_test.h>

namespace fairlight {

/// Estimators whose draws depend on each other: points of a low-discrepancy set, strata, adaptive stages, the
/// states of a chain. Only the whole replicate, made anew from numbers of its own, is a draw. `replicate(r)` gives
/// the estimate of replicate r, a function of r and the seed alone.

/// The mean of replicates with a declared range, by the core test. Guarantee: exact.
template <class Replicate>
Finding test_replicates(const Trial& trial, const Reference& reference, Replicate&& replicate) {
  return test_means(trial, {reference}, [&](std::uint64_t first, std::vector<std::vector<double>>& channels) {
    for (std::size_t i = 0; i < channels[0].size(); ++i) channels[0][i] = replicate(first + i);
  });
}

/// The same without a range. Guarantee: asymptotic.
template <class Replicate>
Finding test_replicates(const Trial& trial, double mean, Replicate&& replicate) {
  return sequential_t_test(trial, mean, std::abs(mean),
                           [&](std::uint64_t first, std::vector<std::vector<double>>& channels) {
                             for (std::size_t i = 0; i < channels[0].size(); ++i)
                               channels[0][i] = replicate(first + i);
                           });
}

/// The exponent e of variance ~ n^-e by least squares on logarithms: 1 for independent draws, up to 3 for scrambled
/// nets on smooth integrands. Pairs of (points in a replicate, variance between replicates); at least two, all
/// positive, or throws std::invalid_argument.
double convergence_exponent(std::span<const std::pair<double, double>> variances);

}  // namespace fairlight

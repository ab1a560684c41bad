#pragma once

#include <cmath>
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

}  // namespace fairlight

#pragma once

#include <fairlight/estimators/vertex_source.h>
#include <fairlight/stats/second_order.h>
#include <fairlight/validation/checks/claim.h>
#include <fairlight/validation/checks/numbers.h>

namespace fairlight {

/// The numbers of vertex v of a path of a pixel, as renders take them. A fault can replace them.
struct NumbersOfVertices {
  static SampleBlock<double> of(const StreamKey& key, std::uint32_t pixel, std::uint32_t path, std::uint32_t v) {
    return IndependentNumbers(key).block<double>({pixel, path, v}, 0);
  }
};

/// Numbers that differ only in the pixel, the path or the vertex are uncorrelated. The mean of a
/// pixel does not show a correlation.
template <class Numbers = NumbersOfVertices>
Claim streams_uncorrelated_claim() {
  return {.name = "stream.apart",
          .kind = "second order",
          .subjects = {"PhiloxStream", "IndependentNumbers"},
          .statement = "the same number of two pixels, of two paths and of two vertices is uncorrelated",
          .source = "Salmon et al. 2011: counters that differ",
          .margin_factor = 5,
          .check = [](const Trial& trial) {
            const StreamKey key(trial.seed, trial.claim);
            return test_uncorrelated(trial, {0.5, 0.5}, 0.5, 1.0 / 12, [&](std::uint64_t i) {
              const auto which = i % 3;
              const auto number = [&](std::uint32_t other) {
                // The path number grows with the pixel number. Otherwise a fault that ignores the
                // pixel would give the same numbers in every draw.
                const std::uint32_t base = number_in_key(2 * i, "pixels");
                return Numbers::of(key, base + (which == 0 ? other : 0), base + (which == 1 ? other : 0),
                                   which == 2 ? other : 0)[i / 3 % 5];
              };
              return std::pair(number(0), number(1));
            });
          }};
}

}  // namespace fairlight

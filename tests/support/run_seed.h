#pragma once

#include <cstdint>
#include <iostream>

#include <fairlight/stats/seed.h>

namespace fairlight::testing {

/// A seed that is drawn for every run of a test program, and printed once: what is random in a test
/// is random in every run.
inline std::uint64_t run_seed() {
  static const std::uint64_t seed = [] {
    const std::uint64_t drawn = fresh_seed();
    std::cout << "seed of this run: " << seed_text(drawn) << std::endl;
    return drawn;
  }();
  return seed;
}

}  // namespace fairlight::testing

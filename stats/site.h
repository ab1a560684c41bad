#pragma once

#include <cstdint>
#include <random>
#include <string>

#include <fairlight/stats/manifest.h>

namespace fairlight {

/// The generator that is passed to estimators under test. Its seed comes from the run's seed and
/// the claim's name.
using Generator = std::mt19937_64;

/// The place of an expectation in a test program. It determines the expectation's share of the
/// false alarms and its random numbers.
struct Site {
  std::string name;       ///< name of the test, unique in the program
  std::uint64_t tests;    ///< number of tests in the whole program, whatever subset runs
  std::uint64_t ordinal;  ///< number of the expectation in its test: 1, 2, ...
  std::string replay;     ///< how to run the test again, without the seed
  /// Number of the run of the program's tests: 0, 1, ... Each has a seed of its own; a replay of it
  /// is run 0 with that seed.
  std::uint64_t repetition = 0;
};

/// The trial at a site. The program's tests share the false-alarm budget of 1e-6 of a run equally.
/// Within a test the k-th expectation has the part 6 / (pi k)^2, which sums to 1 over all k. So no
/// list of expectations is needed, and running a subset changes no share. The seed is
/// FAIRLIGHT_SEED (hexadecimal) if that is set, otherwise fresh. Throws std::invalid_argument for a
/// margin outside (0,1) or a seed that cannot be parsed.
Trial trial_at(const Site& site, double margin);

/// A generator for a trial's claim. Different values of `purpose` give independent generators.
Generator generator_for(const Trial& trial, const std::string& purpose = "");

}  // namespace fairlight

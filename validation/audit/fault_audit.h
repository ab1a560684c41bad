#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/run/run_claims.h>

namespace fairlight {

/// The results of one fault in one claim, over several seeds.
struct FaultOutcome {
  const Fault* fault;
  const Claim* claim;
  double effect = 0;        ///< its relative bias, the mean over seeds; NaN if a seed had no draw
  double margin = 0;        ///< the bias that the claim must exclude
  std::uint64_t draws = 0;  ///< the mean number of draws to the verdict
  double seconds = 0;       ///< the mean time to the verdict, on one thread [s]
  int caught = 0;           ///< the number of seeds that found it `biased`
  int seeds = 0;
  std::string note{};  ///< the note on the first seed
};

/// Runs every fault of the catalogue through its claims, with the seeds run_options.seed, + 1, ...
/// The seeds determine the results, whatever the threads, except for the seconds.
std::vector<FaultOutcome> audit_faults(const RunOptions& run_options, int seeds, const Progress& progress = {});

/// A fault that no claim catches with every seed.
struct Survivor {
  const Fault* fault;
  std::string reason;
  bool expected;  ///< whether the catalogue expects it; it says why
};
std::vector<Survivor> survivors(const std::vector<FaultOutcome>& outcomes);

}  // namespace fairlight

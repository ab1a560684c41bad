#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/run/run_claims.h>

namespace fairlight {

/// How one claim fared against one fault, over several seeds.
struct FaultOutcome {
  const Fault* fault;
  const Claim* claim;
  double effect = 0;  ///< the relative bias that it induces, the mean over seeds; not a number if one had no draw
  double margin = 0;  ///< the bias that the claim excludes
  std::uint64_t draws = 0;  ///< the mean number to the verdict
  double seconds = 0;       ///< the mean time to the verdict, on one thread
  int caught = 0;           ///< how many seeds said `biased`
  int seeds = 0;
  std::string note{};  ///< of the first seed: what was found, where it was no bias
};

/// Runs every fault of the catalogue through its claims, with seeds run_options.seed, + 1, ... Exact to the seed,
/// whatever the threads, but for the seconds.
std::vector<FaultOutcome> audit_faults(const RunOptions& run_options, int seeds, const Progress& progress = {});

/// A fault that none of its claims catches with every seed.
struct Survivor {
  const Fault* fault;
  std::string reason;
  bool expected;  ///< by the catalogue, which says why
};
std::vector<Survivor> survivors(const std::vector<FaultOutcome>& outcomes);

}  // namespace fairlight

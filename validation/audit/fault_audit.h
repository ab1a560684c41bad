#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <fairlight/validation/conformance.h>
#include <fairlight/validation/faults/catalogue.h>

namespace fairlight {

/// How one claim fared against one fault, over several seeds.
struct FaultOutcome {
  const Fault* fault;
  std::string claim;
  double effect;        ///< the bias that the fault induces in the claim, relative: the mean over seeds
  std::uint64_t draws;  ///< the mean number to the verdict
  int caught;           ///< how many seeds said `biased`
  int seeds;
};

/// Runs every fault of the catalogue through its claims, with seeds conformance.seed, + 1, ... Exact to the seed,
/// whatever the threads.
std::vector<FaultOutcome> audit_faults(const Conformance& conformance, int seeds, const Progress& progress = {});

}  // namespace fairlight

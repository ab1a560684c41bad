#pragma once

#include <cstdint>
#include <vector>

#include <fairlight/render/render_image.h>
#include <fairlight/validation/claim.h>

namespace fairlight {

/// How a run of claims is to be made.
struct Conformance {
  std::uint64_t seed;
  double budget = 1e-6;  ///< probability of a false alarm in a run of the whole registry
  double beta = 0.01;    ///< miss rate of each claim at its margin
  double margin = 1e-3;  ///< relative; a claim's own is this times its factor
  int threads = 1;
};

/// What came of one claim.
struct Outcome {
  const Claim* claim;
  Finding finding;
  double seconds;
};

/// The trial of a row of the registry: its share of the budget is the same whatever else runs.
/// Throws std::invalid_argument for a name that is not in the registry, or a margin or budget outside (0,1).
Trial trial_of(const std::string& claim, const Conformance& conformance);

/// Runs the claims, each on one thread, and returns their outcomes in the same order. The findings are functions of
/// the seed alone.
std::vector<Outcome> run_claims(const std::vector<const Claim*>& claims, const Conformance& conformance,
                                const Progress& progress = {});

/// The worst verdict of all.
Verdict overall(const std::vector<Outcome>& outcomes);

}  // namespace fairlight

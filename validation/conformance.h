#pragma once

#include <cstdint>
#include <vector>

#include <fairlight/render/render_image.h>
#include <fairlight/stats/evidence.h>
#include <fairlight/validation/claim.h>

namespace fairlight {

/// How a run of claims is to be made.
struct Conformance {
  Manifest::Terms terms;
  int threads = 1;
  bool evidence = false;  ///< whether outcomes keep what the tests saw
};

/// What came of one claim.
struct Outcome {
  const Claim* claim;
  Finding finding;
  double seconds;
  Evidence evidence{};
};

/// The whole registry on the terms of a run: a claim's share of the budget is the same whatever else runs.
/// Throws as Manifest does: for a budget outside (0,1) here; for a name that is not in the registry, or a margin outside
/// (0,1), when a trial is asked for.
Manifest manifest_of(const Conformance& conformance);

/// Runs the claims, each on one thread, and returns their outcomes in the same order. The findings are functions of
/// the seed alone.
std::vector<Outcome> run_claims(const std::vector<const Claim*>& claims, const Conformance& conformance,
                                const Progress& progress = {});

/// The worst verdict of all.
Verdict overall(const std::vector<Outcome>& outcomes);

}  // namespace fairlight

#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <fairlight/render/render_image.h>
#include <fairlight/stats/evidence.h>
#include <fairlight/validation/checks/claim.h>

namespace fairlight {

/// The options of a run of claims.
struct RunOptions {
  Manifest::Terms terms;
  int threads = 1;
  std::vector<std::string> instructions{""};  ///< every claim runs once for each; they share the budget
  double seconds =
      std::numeric_limits<double>::infinity();  ///< after these, a claim without a verdict is undecided
  bool evidence = false;                        ///< whether outcomes keep all evidence of the tests
  bool fail_fast = false;                       ///< whether no claim goes on after one has failed
};

/// What a ledger certifies of a claim, from all of its runs together.
struct Standing {
  std::size_t runs;
  double margin;  ///< infinity if it certifies none
};

/// The result of one claim.
struct Outcome {
  const Claim* claim;
  Finding finding;
  double seconds;
  Evidence evidence{};       ///< the margin grid of claims that add up; all if it was asked for
  bool out_of_time = false;  ///< whether the run ended before its verdict
  std::optional<Standing> ledger{};
};

/// Whether a claim is biased, or is undecided although there was time.
bool failed(const Outcome& outcome);

/// The part of the budget for components, whose claims show together what none shows alone.
inline constexpr double part_for_components = 0.1;

/// The whole registry on the terms of a run. The share of a claim in the budget is the same
/// whatever else runs, and is divided equally between the instruction sets. Throws as Manifest
/// does: here for a budget outside (0,1); when a trial is asked for, for a name that is not in the
/// registry or a margin outside (0,1).
Manifest manifest_of(const RunOptions& run_options);

/// Runs each claim on one thread, and returns the outcomes in the order of the claims. A finding
/// depends on the seed alone, not on other claims, threads or the order in which claims run.
///
/// Every claim first runs for some milliseconds, which shows gross errors and what each will cost.
/// The others then run again from the start, the longest first, so that all threads end together.
/// With a time limit, those with an apparent bias go first, then the shortest; when it ends, the
/// rest are undecided, with intervals that hold. Throws std::invalid_argument unless the seconds
/// are positive, and what a claim throws.
std::vector<Outcome> run_claims(const std::vector<const Claim*>& claims, const RunOptions& run_options,
                                const Progress& progress = {});

/// The worst verdict of all claims.
Verdict overall(const std::vector<Outcome>& outcomes);

}  // namespace fairlight

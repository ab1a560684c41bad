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

/// How a run of claims is to be made.
struct RunOptions {
  Manifest::Terms terms;
  int threads = 1;
  std::vector<std::string> instructions{""};  ///< one run of every claim for each, which share the budget
  double seconds =
      std::numeric_limits<double>::infinity();  ///< when they are over, what has no verdict is undecided
  bool evidence = false;                        ///< whether outcomes keep what the tests saw
};

/// What a ledger certifies of a claim, by all of its runs together.
struct Standing {
  std::size_t runs;
  double margin;  ///< infinite where it certifies none
};

/// What came of one claim.
struct Outcome {
  const Claim* claim;
  Finding finding;
  double seconds;
  Evidence evidence{};
  bool out_of_time = false;  ///< that the time was up before its verdict
  std::optional<Standing> ledger{};
};

/// Biased, or undecided though there was time.
bool failed(const Outcome& outcome);

/// The whole registry on the terms of a run: a claim's share of the budget is the same whatever else runs,
/// and is parted equally between the instruction sets.
/// Throws as Manifest does: for a budget outside (0,1) here; for a name that is not in the registry, or a margin outside
/// (0,1), when a trial is asked for.
Manifest manifest_of(const RunOptions& run_options);

/// Runs the claims, each on one thread, and returns their outcomes in the same order. A finding is a function of the seed
/// alone: neither the others, nor the threads, nor the order in which they run change it.
///
/// Every claim is begun, for some milliseconds. Most of what is grossly wrong shows then, and so does what each will cost. The
/// others then have their second turn, from the start: the longest first, so that all threads end together. Where the time is
/// limited, those first whose bias seems not to be zero, then the shortest, so that as many as possible come to their verdict;
/// what has none when the time is up is undecided, and its interval holds all the same.
/// Throws std::invalid_argument unless the seconds are positive; and what a claim throws.
std::vector<Outcome> run_claims(const std::vector<const Claim*>& claims, const RunOptions& run_options,
                                const Progress& progress = {});

/// The worst verdict of all.
Verdict overall(const std::vector<Outcome>& outcomes);

}  // namespace fairlight

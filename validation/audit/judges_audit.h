#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <fairlight/validation/run/run_claims.h>

namespace fairlight {

/// A count out of several.
struct Share {
  int count = 0;
  int of = 0;
};

/// How one judge fared, all on the same draws: those that the core test took to its verdict, and as many as it takes to certify the
/// right code, a number that was found with another seed.
struct JudgeOutcome {
  std::string name;
  Share alarms{}, alarms_planned{};  ///< runs of right code that it failed
  Share suites{};                    ///< seeds with which it failed any row of right code, of planned size
  Share kills{}, kills_planned{};    ///< runs of wrong code that it failed
  Share faults{};  ///< faults that it failed with every seed in one of their rows, of planned size
  std::vector<std::string> missed{};  ///< the other faults
};

struct JudgesOutcome {
  std::vector<JudgeOutcome> judges;  ///< fairlight first
  int rows;                          ///< claims about a mean that the catalogue's faults break
  int cells;                         ///< pairs of such a fault and such a claim
  double planned_draws;              ///< of all rows together
};

/// Runs the claims about means that the catalogue's faults break, with right code and with wrong, and lets everybody judge the draws.
/// Faults that are known to survive are left out. The sizes come from the seed, the runs from those after it. Exact to the seed.
JudgesOutcome audit_judges(const RunOptions& run_options, int seeds, const Progress& progress = {});

}  // namespace fairlight

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <fairlight/validation/run/run_claims.h>

namespace fairlight {

/// A count out of a total.
struct Share {
  int count = 0;
  int of = 0;
};

/// The results of one judge. All judges get the same draws, in two sizes: those that fairlight took
/// to its verdict, and a planned number, which fairlight took to certify right code with another
/// seed.
struct JudgeOutcome {
  std::string name;
  Share alarms{}, alarms_planned{};   ///< failed runs of right code
  Share suites{};                     ///< seeds with a failed row of right code, in the planned size
  Share kills{}, kills_planned{};     ///< failed runs of wrong code
  Share faults{};                     ///< faults with a row that failed with every seed, in the planned size
  std::vector<std::string> missed{};  ///< the faults that `faults` does not count
};

struct JudgesOutcome {
  std::vector<JudgeOutcome> judges;  ///< fairlight first
  int rows;                          ///< claims about a mean that faults of the catalogue break
  int cells;                         ///< pairs of such a claim and a fault
  double planned_draws;              ///< the sum over all rows
};

/// Runs the claims about means that faults of the catalogue break, with right and with wrong code,
/// and gives the draws to every judge. Leaves out faults that are known to survive. The first seed
/// gives the planned sizes, the next ones the runs. The seeds determine the results.
JudgesOutcome audit_judges(const RunOptions& run_options, int seeds, const Progress& progress = {});

}  // namespace fairlight

#pragma once

#include <functional>
#include <vector>

#include <fairlight/stats/evidence_sum.h>
#include <fairlight/validation/audit/tester_audit.h>

namespace fairlight {

/// The result of the core test on a uniform law of mean 1 that is off by `bias`.
struct LeavingRun {
  Finding finding;
  EvidenceSum evidence_sum;
};
LeavingRun run_for_sum(const Trial& trial, double bias);

/// The results of ledgers of 100 runs and of the runs themselves, at a level of 1e-8 and a miss
/// rate of 0.01.
struct LedgerOutcome {
  double bias;      ///< of the draws, as a multiple of the margin of a run
  int runs;         ///< in all ledgers
  int runs_biased;  ///< the runs with the verdict `biased`
  int runs_certified;
  int ledgers;
  int ledgers_biased;
  int ledgers_wrong;    ///< the ledgers that certified a margin at or below the bias
  double median_finer;  ///< the median over ledgers of a run's margin divided by the ledger's
  bool passed() const;
};

/// Requires for right draws that half of the ledgers certify a margin of at most an eighth of a
/// run's and that none is biased. Requires for draws that are off by a third of the margin, which
/// single runs certify, that every ledger is biased. Requires for all biases, one of which is a
/// margin of the grid, that no more ledgers certify a margin at or below it than the miss rate
/// allows. Reports the biases in between.
std::vector<LedgerOutcome> audit_ledger(const TesterAudit& audit, const Progress& progress = {});

}  // namespace fairlight

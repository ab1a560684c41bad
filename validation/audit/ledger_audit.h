#pragma once

#include <functional>
#include <vector>

#include <fairlight/stats/evidence_sum.h>
#include <fairlight/validation/audit/tester_audit.h>

namespace fairlight {

/// The core test on a uniform law of mean 1, off by `bias`, with the evidence that it leaves.
struct LeavingRun {
  Finding finding;
  EvidenceSum evidence_sum;
};
LeavingRun run_for_sum(const Trial& trial, double bias);

/// How ledgers of 100 runs fare beside the runs themselves, at a level of 1e-8 and the miss rate 0.01.
struct LedgerOutcome {
  double bias;      ///< of the draws, in units of the runs' margin
  int runs;         ///< in all ledgers
  int runs_biased;  ///< that said so, each by itself
  int runs_certified;
  int ledgers;
  int ledgers_biased;
  double
      median_finer;  ///< the margin of a run over the one that a ledger certifies: half of the ledgers are as fine
  bool passed() const;
};

/// Right draws: half of the ledgers certify a margin at most an eighth of a run's, and none calls them biased. Draws that are off by a
/// third of the margin, which single runs certify: every ledger calls them biased. What is between is reported.
std::vector<LedgerOutcome> audit_ledger(const TesterAudit& audit, const Progress& progress = {});

}  // namespace fairlight

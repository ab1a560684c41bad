#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include <fairlight/validation/run/ledger.h>
#include <fairlight/validation/run/run_claims.h>
#include <fairlight/validation/run/sources.h>

namespace fairlight {

/// A run of claims whose evidence goes to a ledger. A claim's verdict in it is `biased` when that of its runs is.
class LedgerRun {
 public:
  /// Throws where the ledger cannot be read or written, or where it is not known which sources the claims rest on: before the run,
  /// not after it.
  LedgerRun(const std::string& path, const std::vector<const Claim*>& claims, const BuildPlaces& places);

  /// Appends what the run saw, and reads what the ledger says now, with the runs of others that came between.
  void add(std::vector<Outcome>& outcomes, const RunOptions& run_options);

  /// What the ledger certifies, in a line.
  void print(std::FILE* out) const;

 private:
  void judge(Outcome& outcome, const Trial& trial);

  std::string path_;
  std::map<const Claim*, std::uint64_t> contents_;  // of its sources and its instruction set
  Ledger ledger_;
  std::size_t runs_ = 0;       // of the claim that has most
  std::size_t kept_ = 0;       // claims that have any
  std::vector<double> finer_;  // the run's margin over the ledger's, where that is finer
};

}  // namespace fairlight

#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include <fairlight/validation/run/ledger.h>
#include <fairlight/validation/run/run_claims.h>
#include <fairlight/validation/run/sources.h>

namespace fairlight {

/// A run of claims that adds its evidence to a ledger. A claim is also `biased` if the evidence of
/// all its runs in the ledger says so.
class LedgerRun {
 public:
  /// Throws before the run if the ledger cannot be read or written, or if the sources of the claims
  /// are unknown.
  LedgerRun(const std::string& path, const std::vector<const Claim*>& claims, const BuildPlaces& places);

  /// Appends the evidence of the run, then reads the ledger again, with the runs that others have
  /// added meanwhile.
  void add(std::vector<Outcome>& outcomes, const RunOptions& run_options);

  /// Prints in one line what the ledger certifies.
  void print(std::FILE* out) const;

 private:
  void judge(Outcome& outcome, const Trial& trial);

  std::string path_;
  std::map<const Claim*, std::uint64_t> contents_;  // hash of the sources and the instruction set
  Ledger ledger_;
  std::size_t runs_ = 0;       // the number of runs of the claim that has most
  std::size_t kept_ = 0;       // the number of claims with an entry
  std::vector<double> finer_;  // the run's margin divided by the ledger's, where the ledger's is finer
};

}  // namespace fairlight

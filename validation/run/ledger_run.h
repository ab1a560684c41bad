#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include <fairlight/validation/run/components.h>
#include <fairlight/validation/run/ledger.h>
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
  /// added meanwhile. A component is judged by all its claims in the ledger, whichever ran.
  void add(std::vector<Outcome>& outcomes, std::vector<ComponentOutcome>& components,
           const RunOptions& run_options);

  /// Prints in one line what the ledger certifies.
  void print(std::FILE* out) const;

 private:
  const LedgerEntry* entry_of(const Claim& claim) const;
  std::uint64_t content_of(const Claim& claim) const;
  void judge(Outcome& outcome, const Trial& trial);
  void judge(ComponentOutcome& component, const RunOptions& run_options) const;

  std::string path_;
  std::map<std::string, std::uint64_t> contents_;  // hash of the sources, by the file of the claims
  Ledger ledger_;
  std::size_t runs_ = 0;       // the number of runs of the claim that has most
  std::size_t kept_ = 0;       // the number of claims with an entry
  std::vector<double> finer_;  // the run's margin divided by the ledger's, where the ledger's is finer
};

}  // namespace fairlight

#pragma once

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <fairlight/validation/audit/mutation_run.h>

namespace fairlight {

/// The fates of mutants, one line of JSON for each in a file, so that a run that was stopped can
/// continue.
class MutationResults {
 public:
  /// Reads the file, if there is one; an empty path keeps nothing. Throws std::runtime_error if it
  /// holds anything else.
  explicit MutationResults(const std::string& path);

  bool knows(const Mutant& mutant) const;
  const Fate& fate(const Mutant& mutant) const { return fates_.at(mutant.name()); }

  /// Keeps a fate. Several threads may call it at once.
  void add(const Mutant& mutant, const Fate& fate);

 private:
  std::string path_;
  std::map<std::string, Fate> fates_;
  mutable std::mutex mutex_;
};

/// How many mutants met each fate.
struct MutationCounts {
  std::size_t killed_by_claims = 0, killed_by_tests = 0, survived = 0, equivalent = 0, no_program = 0;

  std::size_t killed() const { return killed_by_claims + killed_by_tests; }
  /// Of the mutants that compile and are not equivalent.
  double percent_killed() const;
  double percent_killed_by_claims() const;
};
MutationCounts counts_of(const std::vector<Mutant>& mutants, const MutationResults& results);

/// One sentence.
std::string summary(const MutationCounts& counts);

/// A page of the mutants that no claim noticed.
std::string mutation_page(const std::vector<Mutant>& mutants, const MutationResults& results,
                          const std::string& command);

/// `{mutants, killed, killed_by_claims, killed_by_tests_only, survived, equivalent, no_program, kinds,
/// survivors, tests_only}`: kinds holds the same counts by kind, the last two the mutants.
nlohmann::json mutation_json(const std::vector<Mutant>& mutants, const MutationResults& results,
                             const std::string& seed);

}  // namespace fairlight

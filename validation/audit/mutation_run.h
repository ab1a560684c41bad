#pragma once

#include <mutex>
#include <set>
#include <string>
#include <vector>

#include <fairlight/validation/audit/mutant_compiler.h>
#include <fairlight/validation/audit/mutants.h>

namespace fairlight {

/// The fate of a mutant.
struct Fate {
  enum class Kind {
    killed,           ///< a claim fails, or the program stops
    killed_by_tests,  ///< every claim that ran holds, and a test of the file fails
    survived,         ///< every claim that ran holds, and the tests pass
    equivalent,       ///< it changes no object file
    no_program,       ///< it does not compile
  };
  Kind kind;
  std::string by;  ///< the claim or test that killed it, or how the program stopped; else the files that ran
  double seconds = 0;
};
const char* name(Fate::Kind kind);
Fate::Kind fate_named(const std::string& name);  ///< throws std::invalid_argument for any other name

/// How much to run for a mutant.
struct MutationLimits {
  std::size_t files = 3;  ///< files of claims that are compiled
  double seconds = 60;    ///< after these, no further file of claims begins
  double verify = 20;     ///< seconds for the claims of one file
};

/// Compiles mutants into claims and runs these, and if no claim fails, tests. docs/mutants.md says
/// which. Everything is compiled anew that the claims call and that has code from the changed lines.
class MutationRun {
 public:
  /// Works in a temporary folder, which the destructor removes. Throws std::runtime_error if the
  /// build is gone or a source is newer than the program.
  MutationRun(const BuildPlaces& places, const MutationLimits& limits);

  /// Runs claims, then tests, until one kills the mutant. Several threads may call it at once.
  Fate judge(const Mutant& mutant);

 private:
  /// Claims to run together, and what to compile before: files of claims/ and library objects.
  struct Stage {
    std::vector<std::string> claim_files;
    std::vector<std::string> objects;
    double worth = 0;  ///< the part of its code that is from the changed line
  };

  std::set<std::string> called_by(const std::string& claims, bool in_any_run);
  double worth_of(const Mutant& mutant, const Stage& stage);
  std::vector<Stage> stages_of(const Mutant& mutant, bool in_any_run);
  std::vector<std::string> with_code(const Mutant& mutant, const std::vector<std::string>& objects);
  int code_of(const Mutant& mutant, const std::string& object, int first_line, int last_line);
  Fate judge_in(MutantCompiler::Job& job);
  bool compile_all(MutantCompiler::Job& job, const std::vector<std::string>& objects);
  bool link(const MutantCompiler::Job& job, const std::string& command, const std::string& program,
            const std::string& objects) const;
  std::string killer(const MutantCompiler::Job& job, const std::vector<std::string>& claim_files) const;
  Fate judge_by_tests(MutantCompiler::Job& job, std::string run);
  bool test_fails(const MutantCompiler::Job& job, const std::string& test,
                  const std::vector<std::string>& needed) const;

  BuildPlaces places_;
  MutationLimits limits_;
  Workplace scratch_;  // holds the folders of mutants
  BuiltObjects objects_;
  MutantCompiler compiler_;
  std::string link_;
  std::mutex mutex_;
};

}  // namespace fairlight

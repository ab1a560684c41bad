#pragma once

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include <fairlight/validation/audit/mutants.h>
#include <fairlight/validation/run/sources.h>

namespace fairlight {

/// The fate of a mutant.
struct Fate {
  enum class Kind {
    killed,      ///< a claim is biased, a test of the component fails, or a program stops
    survived,    ///< every claim that ran is certified, and the tests pass
    equivalent,  ///< it changes no object file
    no_program,  ///< it does not compile
  };
  Kind kind;
  std::string by;  ///< the claim or test that killed it, or how the program stopped; else the files that ran
  double seconds = 0;
};
const char* name(Fate::Kind kind);
Fate::Kind fate_named(const std::string& name);  ///< throws std::invalid_argument for any other name

/// Compiles mutants into claims and runs these. If no claim notices, it runs the tests that name
/// the components of the source. The source folder stays unchanged: the changed header is in a
/// folder that comes first in the search path. It compiles without the last optimisations, and
/// links the program as the build does.
class MutationRun {
 public:
  /// Works in a temporary folder, which the destructor removes. Throws std::runtime_error if the
  /// build is gone or a source is newer than the program.
  explicit MutationRun(const BuildPlaces& places);

  /// The files of claims/ that depend on a source. Those with the most claims about its components
  /// come first.
  std::vector<std::string> concerned(const std::string& source);

  /// At most three tests in the folder of the source that name its components: first the one with
  /// its name, then those with the most mentions.
  std::vector<std::string> tests_of(const std::string& source) const;

  /// Runs the claims of at most `most_files` of the files that the mutant changes, then the tests,
  /// until one kills it. Several threads may call it at once.
  Fate judge(const Mutant& mutant, std::size_t most_files);

 private:
  // A temporary folder, which the destructor removes.
  struct Workplace {
    explicit Workplace(const std::string& parent);
    Workplace(const Workplace&) = delete;
    Workplace& operator=(const Workplace&) = delete;
    ~Workplace();
    std::string object() const { return folder + "/changed.o"; }
    std::string program() const { return folder + "/fairlight"; }

    std::string folder;
  };

  Fate judge_in(const Workplace& place, const Mutant& mutant, std::size_t most_files);
  bool compile(const Workplace& place, const std::string& source);
  bool compile_to(const Workplace& place, const std::string& source, const std::string& object);
  std::string parsed_once(const std::string& command);
  bool same_as_unchanged(const Workplace& place, const std::string& source);
  void link(const Workplace& place, const std::string& command, const std::string& program) const;
  std::string killer(const Workplace& place, const std::string& claim_file) const;
  std::string failing_test(const Workplace& place, const std::string& test) const;

  BuildPlaces places_;
  Workplace scratch_;  // holds the objects of the right sources, and the folders of mutants
  std::string link_;
  Sources sources_;
  std::map<std::string, std::string> compile_;  // by source
  std::map<std::string, std::string> headers_;  // our precompiled headers, by the name of the build's
  std::mutex mutex_, unchanged_;
};

}  // namespace fairlight

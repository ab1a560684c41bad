#pragma once

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include <fairlight/validation/audit/mutants.h>
#include <fairlight/validation/run/sources.h>

namespace fairlight {

/// What became of a mutant.
struct Fate {
  enum class Kind {
    killed,      ///< a claim says `biased`, a test of the component fails, or a program stops
    survived,    ///< every claim that was run is certified, and the tests pass
    equivalent,  ///< the compiler makes the same of every file concerned
    no_program,  ///< it does not compile
  };
  Kind kind;
  std::string by;  ///< the claim or the test that killed it, or how the program stopped; or which files were run
  double seconds = 0;
};
const char* name(Fate::Kind kind);
Fate::Kind fate_named(const std::string& name);  ///< throws std::invalid_argument for any other name

/// Compiles mutants into claims, and runs these; and where no claim notices, into the tests that name its components. The sources stay as they
/// are: the changed header stands in a folder that is searched first, a file is compiled against it without the last optimisations, and
/// the program is linked as its build links it.
class MutationRun {
 public:
  /// Works in a folder of its own, gone with it, where temporary ones are. Throws std::runtime_error where the build is gone or the sources are
  /// newer than the program.
  explicit MutationRun(const BuildPlaces& places);

  /// The files of claims/ that rest on a source, those with the most claims about its components first.
  std::vector<std::string> concerned(const std::string& source);

  /// At most three tests of the source's folder that name its components, that of its own name first and then those that do so the most.
  std::vector<std::string> tests_of(const std::string& source) const;

  /// Runs the claims of at most so many of the files concerned that it changes, and then the tests, until one kills it. May be called from several threads at once.
  Fate judge(const Mutant& mutant, std::size_t most_files);

 private:
  // A folder that is gone with it.
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
  std::string parsed_once(const std::string& command);
  bool same_as_unchanged(const Workplace& place, const std::string& source);
  void link(const Workplace& place, const std::string& command, const std::string& program) const;
  std::string killer(const Workplace& place, const std::string& claim_file) const;
  std::string failing_test(const Workplace& place, const std::string& test) const;

  BuildPlaces places_;
  Workplace scratch_;  // of the objects of the right sources, and of the places of mutants
  std::string link_;
  Sources sources_;
  std::map<std::string, std::string> compile_;  // by the source
  std::map<std::string, std::string> headers_;  // by the build's own, which ours are made of
  std::mutex mutex_, unchanged_;
};

}  // namespace fairlight

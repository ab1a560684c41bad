#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include <fairlight/validation/audit/built_objects.h>
#include <fairlight/validation/audit/mutants.h>

namespace fairlight {

/// A temporary folder, which the destructor removes.
struct Workplace {
  explicit Workplace(const std::string& parent);
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;
  ~Workplace();

  std::string folder;
};

/// Compiles objects of a build, with and without a mutant, at -O1. The source folder stays
/// unchanged: a changed header lies in a folder that the compiler searches first, and a changed .cpp
/// is compiled from there. Functions are not flattened (see render/flatten.h), which takes long.
/// Several threads may call it at once.
class MutantCompiler {
 public:
  explicit MutantCompiler(const BuildPlaces& places, const std::string& scratch);

  /// The folder of one mutant. It holds its text, and what was compiled of it.
  struct Job {
    Job(const std::string& scratch, const Mutant& of) : place(scratch), mutant(of) {}
    Workplace place;
    const Mutant& mutant;
    std::map<std::string, bool> changed;  ///< by object: whether it differs from the right one
  };
  /// Writes the text of the mutant.
  void begin(const Job& job) const;

  /// Compiles an object of a mutant, unless it has been. Returns false if it does not compile.
  bool compile(Job& job, const BuiltObject& object);

  /// Compiles right objects that are needed next and that no other thread has begun.
  void prepare(const std::vector<const BuiltObject*>& objects);

  /// How often code in some lines of a file was generated in the right object, and how much code
  /// that has in all [rows of its line table].
  int code_in(const BuiltObject& object, const std::string& file, int first_line, int last_line);
  int size_of(const BuiltObject& object);

  /// The file of an object of a mutant.
  static std::string file_of(const Job& job, const BuiltObject& object);

 private:
  struct Unchanged {
    std::atomic<bool> begun = false;
    std::once_flag compiled;
    std::string bytes;
    std::map<std::string, std::map<int, int>> code;  // rows of the line table, by file and line
    int rows = 0;
  };

  bool compile_to(const BuiltObject& object, const std::string& folder, const std::string& source,
                  const std::string& to);
  std::string with_header(const std::string& command);
  Unchanged& place_of(const BuiltObject& object);
  Unchanged& unchanged(const BuiltObject& object);
  void read_lines(Unchanged& known, const std::string& object) const;

  BuildPlaces places_;
  std::string scratch_;
  std::mutex mutex_, headers_mutex_;
  std::map<std::string, std::string> headers_;  // our precompiled headers, by the name of the build's
  std::map<std::string, std::unique_ptr<Unchanged>> unchanged_;
};

/// Runs a command by the shell in a folder, and returns its exit status.
int shell(const std::string& folder, const std::string& command);

/// A path in quotes for the shell.
std::string quoted(const std::string& path);

}  // namespace fairlight

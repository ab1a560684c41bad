#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include <fairlight/validation/run/sources.h>

namespace fairlight {

/// An object file of a build, as the build made it.
struct BuiltObject {
  std::string path;             ///< relative to the build folder
  std::string source;           ///< relative to the source folder
  std::string command;          ///< compiles it; without the name of the object
  std::set<std::string> files;  ///< all that it includes, and its source, relative to the source folder
};

/// The objects of a build with ninja: which depend on a file, which call which, how programs are
/// linked. Objects for other instruction sets than the baseline are left out.
class BuiltObjects {
 public:
  /// Reads the compile commands, ninja's record of dependencies and the symbols of the objects.
  /// Throws std::runtime_error if the build is gone.
  explicit BuiltObjects(const BuildPlaces& places);

  const BuiltObject& at(const std::string& path) const { return objects_.at(path); }

  /// The objects of claims/ and of the libraries below it that depend on a file.
  std::vector<std::string> with(const std::string& file) const;

  /// The objects of tests in the folder of a file that include it or, for a .cpp, its headers. The
  /// most specific come first, those that include the fewest files of fairlight.
  std::vector<std::string> tests_with(const std::string& file) const;

  /// The object of a source. Throws std::runtime_error if the build does not know it.
  std::string of_source(const std::string& source) const;

  /// The library objects that an object calls, directly or not.
  const std::set<std::string>& called_by(const std::string& path);

  /// The command that links a program of the build. Throws std::runtime_error if ninja does not
  /// know it.
  std::string link_command(const std::string& program) const;

  /// The options of a compile or link command after its compiler, the first word with a path.
  static std::string with_options(const std::string& command, const std::string& options);

 private:
  void read_commands();
  void read_dependencies();
  void read_symbols(const std::vector<std::string>& paths);
  std::string within_source(const std::string& path) const;

  BuildPlaces places_;
  std::map<std::string, BuiltObject> objects_;
  std::map<std::string, std::vector<std::string>> defining_;  // library objects, by symbol
  std::map<std::string, std::vector<std::string>> calls_;     // undefined symbols, by object
  std::map<std::string, std::set<std::string>> called_;
};

}  // namespace fairlight

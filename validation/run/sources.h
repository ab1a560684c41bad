#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>

namespace fairlight {

/// The build folder of a program, its source folder, and the program.
struct BuildPlaces {
  std::string build, source, program;
};

/// The places of this program, as its build recorded them.
BuildPlaces this_build();

/// The files that a claim depends on, from the dependencies that the build recorded: all that its
/// file in claims/ includes, directly or not, and the sources behind the headers of stats/,
/// estimators/ and render/ among these, with all that those include. The sources behind a header
/// are the one with its name, and any in its folder that includes it and has no header of its own.
/// Paths are relative to the source folder; files elsewhere, such as those of the compiler, are
/// left out.
class Sources {
 public:
  /// Throws std::runtime_error if there is no such build, or no ninja to read it.
  explicit Sources(const BuildPlaces& places);

  /// The files that the claims of a file in claims/ depend on. Throws std::runtime_error if the
  /// build does not know that file, or if one of them is newer than the program, which is then out
  /// of date.
  const std::set<std::string>& files_of(const std::string& claim_file);

  /// A hash of the names and contents of these files.
  std::uint64_t content(const std::string& claim_file);

 private:
  void read_dependencies(const std::string& listing);
  std::string within_source(const std::string& path);
  bool stands_behind(const std::string& source, const std::set<std::string>& files);
  std::string read(const std::string& file) const;

  BuildPlaces places_;
  std::map<std::string, std::set<std::string>> needs_;   // the files of a source, as the build recorded them
  std::map<std::string, std::string> names_;             // paths relative to the source folder, or empty
  std::map<std::string, std::set<std::string>> behind_;  // the headers that a library source stands behind
  std::map<std::string, std::set<std::string>> files_;
};

}  // namespace fairlight

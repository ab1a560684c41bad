#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>

namespace fairlight {

/// Where a program was built from what, and the program.
struct BuildPlaces {
  std::string build, source, program;
};

/// Those of this program, as its build knew them.
BuildPlaces this_build();

/// Which files a claim rests on, by what the build noted when it compiled them: what its file in claims/ includes, however
/// indirectly; and of stats/ and render/, which are compiled by themselves, the sources behind the headers among these, with all that
/// they include in turn. Behind a header is the source of its name, and any source of its folder that has no header of its own
/// and includes it. Files are named from the source folder; others, such as the compiler's, are left out.
class Sources {
 public:
  /// Throws std::runtime_error where there is no such build, or no ninja to read it.
  explicit Sources(const BuildPlaces& places);

  /// Of the claims of a file of claims/. Throws std::runtime_error when the build does not know that file, or one of them is newer
  /// than the program, which is then not made of it.
  const std::set<std::string>& files_of(const std::string& claim_file);

  /// A hash of their names and contents.
  std::uint64_t content(const std::string& claim_file);

 private:
  void read_dependencies(const std::string& listing);
  std::string within_source(const std::string& path);
  bool stands_behind(const std::string& source, const std::set<std::string>& files);
  std::string read(const std::string& file) const;

  BuildPlaces places_;
  std::map<std::string, std::set<std::string>> needs_;   // of a source, by what the build noted
  std::map<std::string, std::string> names_;             // of paths, from the source folder; empty for others
  std::map<std::string, std::set<std::string>> behind_;  // the headers that a source of a library stands behind
  std::map<std::string, std::set<std::string>> files_;
};

}  // namespace fairlight

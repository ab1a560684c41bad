#include <algorithm>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include <fairlight/render/atomic_file.h>
#include <fairlight/stats/hash.h>
#include <fairlight/validation/run/sources.h>
#include <fairlight/validation/run/subprocess.h>

namespace fairlight {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view claims_folder = "validation/claims/";

bool of_library(const std::string& source) {
  return source.starts_with("stats/") || source.starts_with("estimators/") || source.starts_with("render/") ||
         source.starts_with("validation/checks/");
}

std::string folder_of(const std::string& file) { return file.substr(0, file.find('/') + 1); }

}  // namespace

BuildPlaces this_build() { return {FAIRLIGHT_BUILD_FOLDER, FAIRLIGHT_SOURCE_FOLDER, "/proc/self/exe"}; }

Sources::Sources(const BuildPlaces& places) : places_(places) {
  const auto fail = [&](const std::string& why) {
    throw std::runtime_error("it is not known which files the claims rest on (" + why + ")");
  };
  if (!fs::exists(places.build + "/build.ninja") || !fs::exists(places.source + "/validation/claims")) {
    fail("the folder \"" + places.build + "\", where this program was built with ninja, or its sources are gone");
  }
  const ProcessResult listing = run_process({"ninja", "-C", places.build, "-t", "deps"});
  if (listing.status != 0) fail("ninja does not list the dependencies noted in \"" + places.build + "\"");
  read_dependencies(listing.out);
}

// Parses the output of `ninja -t deps`: the name of an object, then its files, indented, with its
// own source first; then an empty line.
void Sources::read_dependencies(const std::string& listing) {
  std::istringstream lines(listing);
  std::set<std::string>* needs = nullptr;
  bool first = false;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("    ")) {
      needs = nullptr;
      first = true;
      continue;
    }
    if (needs == nullptr && !first) continue;
    const std::string file = within_source(line.substr(4));
    if (first && file.ends_with(".cpp") && (of_library(file) || file.starts_with(claims_folder)))
      needs = &needs_[file];
    first = false;
    if (needs != nullptr && !file.empty()) needs->insert(file);
  }
  for (const auto& [source, files] : needs_) {
    if (!of_library(source)) continue;
    const std::string header = source.substr(0, source.size() - 3) + "h";
    if (files.contains(header)) {
      behind_[source] = {header};
      continue;
    }
    const std::string text = read(source);
    for (const std::string& file : files) {
      const bool near =
          file.starts_with(folder_of(source)) && text.find("<fairlight/" + file + ">") != std::string::npos;
      if (near) behind_[source].insert(file);
    }
  }
}

// Converts a path of the build to one relative to the source folder, with links resolved. Returns
// an empty string for a file elsewhere.
std::string Sources::within_source(const std::string& path) {
  const auto [known, is_new] = names_.try_emplace(path);
  if (!is_new) return known->second;
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(fs::path(places_.build) / path, error);
  const auto below = [&](const std::string& folder) {
    const fs::path base = fs::weakly_canonical(folder, error);
    return std::mismatch(base.begin(), base.end(), whole.begin(), whole.end()).first == base.end();
  };
  if (!error && below(places_.source) && !below(places_.build)) {
    known->second = whole.lexically_relative(fs::weakly_canonical(places_.source, error)).string();
  }
  return known->second;
}

bool Sources::stands_behind(const std::string& source, const std::set<std::string>& files) {
  return std::ranges::any_of(behind_[source], [&](const std::string& header) { return files.contains(header); });
}

const std::set<std::string>& Sources::files_of(const std::string& claim_file) {
  const auto [known, is_new] = files_.try_emplace(claim_file);
  std::set<std::string>& files = known->second;
  if (!is_new) return files;
  const auto own = needs_.find(std::string(claims_folder) + claim_file);
  if (own == needs_.end()) {
    throw std::runtime_error("the build does not know \"" + claim_file + "\" (build the program again)");
  }
  files = own->second;
  for (std::size_t before = 0; before != files.size();) {
    before = files.size();
    for (const auto& [source, needs] : needs_) {
      if (of_library(source) && stands_behind(source, files)) files.insert(needs.begin(), needs.end());
    }
  }
  const auto built = fs::last_write_time(fs::canonical(places_.program));
  for (const std::string& file : files) {
    std::error_code gone;
    const auto written = fs::last_write_time(fs::path(places_.source) / file, gone);
    if (!gone && written <= built) continue;
    throw std::runtime_error("\"" + file + "\" is " + (gone ? "gone" : "newer than this program") +
                             " (build it again, so that what it finds is found of these sources)");
  }
  return files;
}

std::string Sources::read(const std::string& file) const { return read_whole(places_.source + "/" + file); }

std::uint64_t Sources::content(const std::string& claim_file) {
  std::uint64_t hash = hash_of("");
  for (const std::string& file : files_of(claim_file)) {
    hash = hash_of(file + '\0', hash);
    hash = hash_of(read(file) + '\0', hash);
  }
  return hash;
}

}  // namespace fairlight

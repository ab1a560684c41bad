#include <algorithm>
#include <cstdio>
#include <sstream>
#include <stdexcept>

#include <fairlight/validation/run/since.h>
#include <fairlight/validation/run/subprocess.h>

namespace fairlight {

std::set<std::string> files_changed_since(const std::string& revision, const std::string& source) {
  const auto git = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"git", "-C", source});
    return run_process(arguments);
  };
  if (git({"rev-parse", "--git-dir"}).status != 0) {
    throw std::runtime_error("\"" + source + "\" is not in a git repository (so nothing is known of \"" + revision +
                             "\")");
  }
  ProcessResult commit = git({"rev-parse", "--verify", "--quiet", "--end-of-options", revision + "^{commit}"});
  if (commit.status != 0)
    throw std::runtime_error("\"" + revision + "\" is not a revision of \"" + source + "\" (see git log)");
  commit.out.erase(commit.out.find_last_not_of('\n') + 1);
  const ProcessResult differing =
      git({"diff", "--name-only", "--no-renames", "--relative", "-z", commit.out, "--", "."});
  const ProcessResult added = git({"ls-files", "--others", "--exclude-standard", "-z"});
  if (differing.status != 0 || added.status != 0) {
    throw std::runtime_error("git does not say what differs from \"" + revision + "\" (try git diff)");
  }
  std::istringstream names(differing.out + added.out);
  std::set<std::string> files;
  for (std::string name; std::getline(names, name, '\0');) files.insert(name);
  return files;
}

std::vector<const Claim*> claims_since(const std::string& revision, const std::vector<const Claim*>& claims,
                                       const BuildPlaces& places) {
  Sources sources(places);
  const std::set<std::string> changed = files_changed_since(revision, places.source);
  std::vector<const Claim*> touched;
  for (const Claim* claim : claims) {
    const std::set<std::string>& files = sources.files_of(claim->file);
    if (std::ranges::any_of(changed, [&](const std::string& file) { return files.contains(file); })) {
      touched.push_back(claim);
    }
  }
  std::printf("%zu of %zu claims rest on sources that differ from %s\n", touched.size(), claims.size(),
              revision.c_str());
  return touched;
}

}  // namespace fairlight

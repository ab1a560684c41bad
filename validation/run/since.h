#pragma once

#include <set>
#include <string>
#include <vector>

#include <fairlight/validation/checks/claim.h>
#include <fairlight/validation/run/sources.h>

namespace fairlight {

/// The files that differ from a git revision, or are new, in a source folder. Throws std::runtime_error where there is no git, no
/// repository or no such revision.
std::set<std::string> files_changed_since(const std::string& revision, const std::string& source);

/// Those of the claims that rest on such files, which it counts on standard output.
std::vector<const Claim*> claims_since(const std::string& revision, const std::vector<const Claim*>& claims,
                                       const BuildPlaces& places);

}  // namespace fairlight

#pragma once

#include <set>
#include <string>
#include <vector>

#include <fairlight/validation/checks/claim.h>
#include <fairlight/validation/run/sources.h>

namespace fairlight {

/// The files of a source folder that differ from a git revision or are new. Throws
/// std::runtime_error if there is no git, no repository or no such revision.
std::set<std::string> files_changed_since(const std::string& revision, const std::string& source);

/// The claims that depend on such files. Prints their number on standard output.
std::vector<const Claim*> claims_since(const std::string& revision, const std::vector<const Claim*>& claims,
                                       const BuildPlaces& places);

}  // namespace fairlight

#pragma once

#include <string>
#include <vector>

#include <fairlight/validation/claim.h>

namespace fairlight {

/// Everything that is claimed of the kit. A claim that is not here cannot run.
const std::vector<Claim>& registry();

/// The claims that the patterns name: a whole name, its first dotted parts, or a shell pattern; all for no pattern.
/// Throws std::invalid_argument, naming what exists, for a pattern that matches nothing.
std::vector<const Claim*> select_claims(const std::vector<std::string>& patterns);

}  // namespace fairlight

#pragma once

#include <string>
#include <vector>

#include <fairlight/validation/checks/claim.h>

namespace fairlight {

/// The instruction sets that claims are compiled for and that this machine has, the widest last.
/// They are those of the renderer (see instruction_sets), but under sanitizers only the narrowest.
std::vector<std::string> claimed_instructions();

/// All claims, with packets compiled for an instruction set; an empty name means the widest that
/// this machine has. A claim that is not here cannot run. Every instruction set has the same rows.
/// Throws std::invalid_argument as choose_instructions does.
const std::vector<Claim>& registry(const std::string& instructions = "");

/// The claims that match the patterns, or all if there are none. A pattern is a whole name, the
/// first dotted parts of one, or a shell pattern. Throws std::invalid_argument for a pattern that
/// matches nothing, and names the nearest; throws as registry does.
std::vector<const Claim*> select_claims(const std::vector<std::string>& patterns,
                                        const std::string& instructions = "");

}  // namespace fairlight

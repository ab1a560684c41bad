#pragma once

#include <string>
#include <vector>

#include <fairlight/validation/checks/claim.h>

namespace fairlight {

/// The instruction sets that claims are compiled for and that run here, the widest last: those of the
/// renderer (see instruction_sets), but under sanitizers only the narrowest.
std::vector<std::string> claimed_instructions();

/// Everything that is claimed of the kit, its packets compiled for an instruction set: the widest that
/// runs here if the name is empty. A claim that is not here cannot run. Every instruction set has the
/// same rows. Throws std::invalid_argument as choose_instructions does.
const std::vector<Claim>& registry(const std::string& instructions = "");

/// The claims that the patterns name: a whole name, its first dotted parts, or a shell pattern; all for no pattern.
/// Throws std::invalid_argument, naming the nearest, for a pattern that matches nothing; and as registry does.
std::vector<const Claim*> select_claims(const std::vector<std::string>& patterns,
                                        const std::string& instructions = "");

}  // namespace fairlight

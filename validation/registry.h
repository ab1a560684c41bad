#pragma once

#include <string>
#include <vector>

#include <fairlight/validation/claim.h>

namespace fairlight {

/// Everything that is claimed of the kit. A claim that is not here cannot run. The same rows whatever the instruction set (see
/// render/instruction_sets.h; the widest that runs here for an empty name), whose packets those in packets are about.
/// Throws as choose_instructions does.
const std::vector<Claim>& registry(const std::string& instructions = "");

/// The claims that the patterns name: a whole name, its first dotted parts, or a shell pattern; all for no pattern.
/// Throws std::invalid_argument, naming what exists, for a pattern that matches nothing; and as registry does.
std::vector<const Claim*> select_claims(const std::vector<std::string>& patterns,
                                        const std::string& instructions = "");

}  // namespace fairlight

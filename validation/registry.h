#pragma once

#include <string>
#include <vector>

#include <fairlight/validation/claim.h>

namespace fairlight {

/// The instruction set of that name, if claims in packets are compiled for it: the narrowest that this machine's kind has, and
/// avx512, between which avx2 lies; for an empty name the widest that runs here. Throws as choose_instructions does.
std::string claimed_instructions(const std::string& name);

/// Everything that is claimed of the kit. A claim that is not here cannot run. The same rows whatever the instructions, whose
/// packets those in packets are about. Throws as claimed_instructions does.
const std::vector<Claim>& registry(const std::string& instructions = "");

/// The claims that the patterns name: a whole name, its first dotted parts, or a shell pattern; all for no pattern.
/// Throws std::invalid_argument, naming the nearest, for a pattern that matches nothing; and as registry does.
std::vector<const Claim*> select_claims(const std::vector<std::string>& patterns,
                                        const std::string& instructions = "");

}  // namespace fairlight

#pragma once

#include <string>

#include <fairlight/validation/audit/mutants.h>

namespace fairlight {

/// Why a mutant does what the right source does, though the compiler cannot know it; empty for all others. They are few, and found by looking at
/// survivors; each is known by its file and its lines, for as long as these stand.
std::string known_equivalence(const Mutant& mutant);

}  // namespace fairlight

#pragma once

#include <string>

#include <fairlight/validation/audit/mutants.h>

namespace fairlight {

/// The reason that a mutant behaves as the right source does although the compiler cannot know it,
/// or an empty string. The list is short, and comes from looking at survivors. An entry names a
/// file and a line, and applies as long as the line is unchanged.
std::string known_equivalence(const Mutant& mutant);

}  // namespace fairlight

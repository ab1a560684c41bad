#pragma once

#include <regex>
#include <string>
#include <vector>

namespace fairlight {

/// Which mutants to make: typing errors, errors of meaning, or both.
enum class Operators { slips, meaning, all };
Operators operators_named(const std::string& name);  ///< throws std::invalid_argument for any other name

/// One way to change a line of code. It applies to lines that hold the text `needs`, and that match
/// `pattern`; where `signature` is not empty, only inside of functions whose first line it matches.
/// The first group of the pattern becomes `format`, in which $1, $2, ... are the groups.
struct MutationRule {
  std::string kind;
  Operators of;
  std::string needs;
  std::regex pattern;
  std::string format;
  std::regex signature;
  bool any_function;

  /// The new text for a match; empty groups are left out.
  std::string replacement(const std::smatch& match) const;
};

/// The rules of a choice of operators. docs/mutants.md describes them.
/// Source   slips: Offutt et al. 1996, "An experimental determination of sufficient mutant operators"
///          (ACM TOSEM 5:99)
const std::vector<MutationRule>& mutation_rules();

}  // namespace fairlight

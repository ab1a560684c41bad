#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <fairlight/validation/audit/mutation_rules.h>

namespace fairlight {

/// One small change of a source, a typing error or an error of meaning, that a test suite should
/// notice.
struct Mutant {
  std::string file;        ///< path relative to the source folder
  std::string kind;        ///< the kind of its rule
  int line = 0;            ///< from 1
  std::size_t column = 0;  ///< from 1 [bytes]
  std::size_t begin = 0;   ///< in the file's text [bytes]
  std::size_t length = 0;  ///< of the text that it replaces [bytes]
  std::string replacement;
  std::string before, after;          ///< the trimmed line before and after the change
  int first_line = 0, last_line = 0;  ///< of the function around it; its own line elsewhere

  /// The name of the mutant, "file:line:column before => after", valid while the line is unchanged.
  std::string name() const;
};

/// All mutants of a source by some operators, in the order of their places. It leaves out comments,
/// strings, the preprocessor, template heads, checks that throw, and code for wide instruction sets. Two rules that give the same
/// text count once.
std::vector<Mutant> mutants_of(const std::string& file, const std::string& text,
                               Operators operators = Operators::all);

/// The text of a source with the change made.
std::string mutated(const std::string& text, const Mutant& mutant);

/// A random sample of n mutants, or all if there are fewer, in the order of drawing. The kinds take
/// turns, so that rare ones are seen; of each kind it is a uniform sample. The seed determines it,
/// and a larger sample begins with the smaller ones.
std::vector<Mutant> sample_of(const std::vector<Mutant>& all, std::size_t n, std::uint64_t seed);

}  // namespace fairlight

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace fairlight {

/// One small change of a source, such as a typing error, that a test suite should notice.
struct Mutant {
  std::string file;        ///< path relative to the source folder
  std::string kind;        ///< operator | order | logic | constant | cosine | sign | extreme
  int line = 0;            ///< from 1
  std::size_t column = 0;  ///< from 1 [bytes]
  std::size_t begin = 0;   ///< in the file's text [bytes]
  std::size_t length = 0;  ///< of the text that it replaces [bytes]
  std::string replacement;
  std::string before, after;  ///< the trimmed line before and after the change

  /// The name of the mutant, "file:line:column before => after", valid while the line is unchanged.
  std::string name() const;
};

/// All mutants of a source, in the order of their places. It leaves out comments, strings, the
/// preprocessor, template heads and checks that throw. The classes follow Offutt et al. A constant
/// becomes 2 % larger, as errors of a renderer are often small; 0 becomes 0.02.
/// Source   Offutt et al. 1996, "An experimental determination of sufficient mutant operators" (ACM
///          TOSEM 5:99)
std::vector<Mutant> mutants_of(const std::string& file, const std::string& text);

/// The text of a source with the change made.
std::string mutated(const std::string& text, const Mutant& mutant);

/// A uniform random sample of n mutants, or all if there are fewer, in the order of drawing. The
/// seed determines it, and a larger sample begins with the smaller ones.
std::vector<Mutant> sample_of(const std::vector<Mutant>& all, std::size_t n, std::uint64_t seed);

}  // namespace fairlight

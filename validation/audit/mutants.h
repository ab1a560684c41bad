#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace fairlight {

/// One small change of a source: the slip of a pen that a suite should notice.
struct Mutant {
  std::string file;        ///< from the source folder
  std::string kind;        ///< operator | order | logic | constant | cosine | sign | extreme
  int line = 0;            ///< from 1
  std::size_t column = 0;  ///< from 1 [bytes]
  std::size_t begin = 0;   ///< in the file's text [bytes]
  std::size_t length = 0;  ///< of what is replaced [bytes]
  std::string replacement;
  std::string before, after;  ///< the line, trimmed, without and with the change

  /// Names it for as long as the line stands as it is: "file:line:column before => after".
  std::string name() const;
};

/// All mutants of a source, in the order of their places. Comments, strings, the preprocessor, templates' heads and checks that throw are left alone.
/// The classes follow Offutt et al. 1996 (ACM TOSEM 5:99), "An experimental determination of sufficient mutant operators"; a constant is made 2 %
/// larger, where numbers of a renderer go wrong, or 0.02 of 0.
std::vector<Mutant> mutants_of(const std::string& file, const std::string& text);

/// The text with the change made.
std::string mutated(const std::string& text, const Mutant& mutant);

/// So many of them, at most all, each as likely as any, in the order in which they are drawn: the same for the same seed, of which a greater
/// number goes on where a smaller one ends.
std::vector<Mutant> sample_of(const std::vector<Mutant>& all, std::size_t n, std::uint64_t seed);

}  // namespace fairlight

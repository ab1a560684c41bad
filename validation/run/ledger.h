#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fairlight/stats/evidence_sum.h>

namespace fairlight {

/// What runs of one claim, with certain sources, say together.
struct LedgerEntry {
  std::string claim;
  std::uint64_t content;          ///< hash of the sources
  std::set<std::uint64_t> seeds;  ///< one a run: a run that is replayed says nothing new
  std::uint64_t draws;
  EvidenceSum evidence_sum;
};

/// A file in which runs add up: text, a line an entry, after the line "fairlight ledger 1". A line ends with its checksum. Logarithms of
/// wealth stand in units of 2^-10, rounded down, which makes them no larger than they are.
///
/// Writers only append, under a lock, a whole run at once; a writer that is killed leaves at most the beginning of a line, which is
/// no entry, and which the next writer closes with the word "torn". Other sources begin anew: their hash is another.
class Ledger {
 public:
  using Key = std::pair<std::string, std::uint64_t>;  ///< claim and content

  Ledger() = default;

  static Ledger read(const std::string& path);

  /// The same, but empty where there is no such file yet.
  static Ledger read_if_there(const std::string& path);

  /// Adds the entries of a file, one by one. Throws std::runtime_error for a file that cannot be read, is not a ledger or one of another
  /// version, is cut inside its first line, or is damaged anywhere but at its end.
  void add_file(const std::string& path);

  /// Adds runs that came after. Those with a seed that is here already are left out; entries of several runs that share some with
  /// what is here cannot be taken apart, and the larger is kept.
  void add(const LedgerEntry& later);

  /// Appends entries to the file, which is made if it is not there. Throws std::runtime_error as reading does, and when the file
  /// cannot be written, which then holds what it held.
  static void append(const std::string& path, const std::vector<LedgerEntry>& entries);

  /// The whole ledger as the bytes of a file, an entry for each claim and content.
  std::string text() const;

  /// The entry, or null.
  const LedgerEntry* find(const Key& key) const;
  const std::map<Key, LedgerEntry>& entries() const { return entries_; }

  bool torn() const { return torn_; }                 ///< whether the last file ended in the beginning of a line
  std::size_t repeated() const { return repeated_; }  ///< how many entries were left out

 private:
  std::map<Key, LedgerEntry> entries_;
  bool torn_ = false;
  std::size_t repeated_ = 0;
};

}  // namespace fairlight

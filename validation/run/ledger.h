#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fairlight/stats/evidence_sum.h>

namespace fairlight {

/// The joint evidence of runs of one claim with the same sources.
struct LedgerEntry {
  std::string claim;
  std::uint64_t content;          ///< hash of the sources and the instruction set
  std::set<std::uint64_t> seeds;  ///< one for each run: replaying a run adds nothing
  std::uint64_t draws;
  EvidenceSum evidence_sum;
};

/// A file that sums the evidence of many runs. It is text: the line "fairlight ledger 1", then a
/// line for each entry, which ends with a checksum. Logarithms of wealth are in units of 2^-10,
/// rounded down, so that a reader sees no more evidence than there is.
///
/// Writers only append, under a lock, a whole run at once. A killed writer leaves at most an
/// incomplete line, which is no entry; the next writer ends it with the word "torn". Runs of other
/// sources have other entries, as the hash of the sources differs.
class Ledger {
 public:
  using Key = std::pair<std::string, std::uint64_t>;  ///< the claim, and its content as in LedgerEntry

  Ledger() = default;

  static Ledger read(const std::string& path);

  /// The same, but empty if there is no such file.
  static Ledger read_if_there(const std::string& path);

  /// Adds the entries of a file. Throws std::runtime_error if the file cannot be read, is not a
  /// ledger or has another version, is cut inside its first line, or is damaged anywhere but at its
  /// end.
  void add_file(const std::string& path);

  /// Adds later runs. Skips runs with a seed that is already here. If an entry of several runs
  /// shares only some of its seeds with the entry here, the two cannot be separated, and the larger
  /// is kept.
  void add(const LedgerEntry& later);

  /// Appends entries to the file, and creates it if needed. Throws std::runtime_error as reading
  /// does, and when writing fails, which leaves the file unchanged.
  static void append(const std::string& path, const std::vector<LedgerEntry>& entries);

  /// The whole ledger as the bytes of a file, with one entry for each claim and content.
  std::string text() const;

  /// The entry, or nullptr.
  const LedgerEntry* find(const Key& key) const;
  const std::map<Key, LedgerEntry>& entries() const { return entries_; }

  bool torn() const { return torn_; }                 ///< whether the last file ended in an incomplete line
  std::size_t repeated() const { return repeated_; }  ///< how many entries repeated a seed

 private:
  std::map<Key, LedgerEntry> entries_;
  bool torn_ = false;
  std::size_t repeated_ = 0;
};

}  // namespace fairlight

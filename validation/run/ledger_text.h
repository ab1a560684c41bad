#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <fairlight/validation/run/ledger.h>

namespace fairlight {

inline constexpr std::string_view ledger_header = "fairlight ledger 1\n";

/// An entry as a line, with its checksum and line end. For each channel and each level of its
/// margin grid, a run has four logarithms of wealth: above_reference, below_reference,
/// below_upper_margin and above_lower_margin. A sum of runs has two more: the greatest
/// below_upper_margin and above_lower_margin of a run.
///   run CLAIM CONTENT SEED DRAWS FIRST CHANNELS ...
///   sum CLAIM CONTENT SEED,SEED,... DRAWS FIRST CHANNELS ...
std::string line_of(const LedgerEntry& entry);

/// Parses a line without its line end. Returns nothing if the line is damaged.
std::optional<LedgerEntry> entry_of(std::string_view line);

}  // namespace fairlight

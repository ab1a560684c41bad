#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <fairlight/validation/run/ledger.h>

namespace fairlight {

inline constexpr std::string_view ledger_header = "fairlight ledger 1\n";

/// An entry as a line, with its checksum and its end:
///   run CLAIM CONTENT SEED DRAWS FIRST CHANNELS, then too bright, too dark, not brighter, not darker for each channel's rungs; or
///   sum CLAIM CONTENT SEED,SEED,... DRAWS FIRST CHANNELS, with the greatest of the last two as well, after each rung's four.
std::string line_of(const LedgerEntry& entry);

/// The entry of a line without its end; none where the line is damaged.
std::optional<LedgerEntry> entry_of(std::string_view line);

}  // namespace fairlight

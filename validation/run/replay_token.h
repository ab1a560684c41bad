#pragma once

#include <cstdint>
#include <string>

namespace fairlight {

/// A token that replays a run: the 16 hexadecimal digits of its seed, a hyphen, and 8 digits that
/// identify the sources of this program.
std::string replay_token(std::uint64_t seed);

/// The seed of a token, or of the 1 to 16 hexadecimal digits of a seed alone. Throws
/// std::invalid_argument for anything else, and for a token of other sources, whose draws would
/// differ.
std::uint64_t parse_replay_token(const std::string& text);

}  // namespace fairlight

#pragma once

#include <cstdint>
#include <string_view>

namespace fairlight {

/// FNV-1a of some bytes, or of these and what went before, 64 bits: one byte that is changed always shows. For names and
/// checksums against accidents, not against somebody who wants two that are alike.
/// Source: Fowler, Noll, Vo 1991; draft-eastlake-fnv.
inline std::uint64_t hash_of(std::string_view bytes, std::uint64_t hash = 0xCBF29CE484222325u) {
  for (char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
  return hash;
}

}  // namespace fairlight

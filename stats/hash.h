#pragma once

#include <cstdint>
#include <string_view>

namespace fairlight {

/// The 64-bit FNV-1a hash of some bytes, continued from `hash`. A change of one byte always changes
/// it. For names and for checksums against accidents; it is not cryptographic.
/// Source   Fowler, Noll, Vo 1991; draft-eastlake-fnv
inline std::uint64_t hash_of(std::string_view bytes, std::uint64_t hash = 0xCBF29CE484222325u) {
  for (char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
  return hash;
}

}  // namespace fairlight

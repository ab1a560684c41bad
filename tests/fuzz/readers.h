#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

/// What the program reads from others, each as a function of bytes. An input is taken, or refused by
/// a std::exception whose text is one line; anything else ends the program.
namespace fairlight::fuzz {

using Bytes = std::span<const std::uint8_t>;

void read_picture(Bytes bytes);  ///< an EXR file to resume from
void read_ledger(Bytes bytes);   ///< a ledger
void read_token(Bytes bytes);    ///< a replay token

struct Reader {
  const char* name;
  void (*read)(Bytes bytes);
};
inline constexpr Reader readers[]{{"picture", read_picture}, {"ledger", read_ledger}, {"token", read_token}};

}  // namespace fairlight::fuzz

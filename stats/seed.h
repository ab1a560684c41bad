#pragma once

#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>

namespace fairlight {

/// A seed from the operating system. Every fresh seed in the kit comes from here.
inline std::uint64_t fresh_seed() {
  std::random_device device;
  return (std::uint64_t{device()} << 32) | device();
}

/// The printed form of a seed: 16 hexadecimal digits.
inline std::string seed_text(std::uint64_t seed) {
  constexpr const char* digits = "0123456789abcdef";
  std::string text(16, '0');
  for (std::size_t i = text.size(); i-- > 0; seed >>= 4) text[i] = digits[seed & 15];
  return text;
}

/// Parses a seed of 1 to 16 hexadecimal digits. Throws std::invalid_argument for any other text.
inline std::uint64_t parse_seed(const std::string& text) {
  if (text.empty() || text.size() > 16 || text.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos) {
    throw std::invalid_argument("\"" + text + "\" is not a seed (give 1 to 16 hexadecimal digits)");
  }
  return std::stoull(text, nullptr, 16);
}

}  // namespace fairlight

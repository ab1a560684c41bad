#pragma once

#include <string>

namespace fairlight {

/// A string formatted as by printf; the compiler checks the format against the arguments.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

}  // namespace fairlight

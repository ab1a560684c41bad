#pragma once

#include <string>

namespace fairlight {

/// Text by a format of printf, which the compiler checks against the values.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

}  // namespace fairlight

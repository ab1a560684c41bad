#pragma once

#include <cstdint>

#include <fairlight/render/render_image.h>

namespace fairlight {

/// Every built-in scene in its own strategies, three in a row, each `size` pixels wide and high, from `samples` a pixel.
Film contact_sheet(int size, std::uint64_t samples, std::uint64_t seed, int threads, const Progress& progress);

}  // namespace fairlight

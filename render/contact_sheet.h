#pragma once

#include <cstdint>

#include <fairlight/render/render_image.h>

namespace fairlight {

/// Renders every built-in scene with its own strategies, three in a row, each `size` x `size`
/// pixels with `samples` samples per pixel.
Film contact_sheet(int size, std::uint64_t samples, std::uint64_t seed, int threads, const Progress& progress);

}  // namespace fairlight

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace fairlight {

/// Rasters that are no render: charts and maps. Rows from the top. Written whole or not at all; throw std::runtime_error, and
/// std::invalid_argument when the values are not as many as the pixels.

/// 8-bit sRGB, three bytes a pixel.
void write_png(const std::string& path, int width, int height, std::span<const std::uint8_t> rgb);

/// One number a pixel, and its name.
struct Plane {
  std::string name;
  std::vector<float> values;
};

/// OpenEXR with a channel of 32-bit floats for each plane.
void write_exr(const std::string& path, int width, int height, const std::vector<Plane>& planes);

}  // namespace fairlight

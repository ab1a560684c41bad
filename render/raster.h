#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace fairlight {

/// Writers for maps and contact sheets, with rows from the top. They write a file whole or not at
/// all. They throw std::runtime_error, and std::invalid_argument unless there is a value for each
/// pixel.

/// Writes an 8-bit sRGB PNG from three bytes per pixel.
void write_png(const std::string& path, int width, int height, std::span<const std::uint8_t> rgb);

/// A named channel with one number per pixel.
struct Plane {
  std::string name;
  std::vector<float> values;
};

/// Writes an OpenEXR file with one channel of 32-bit floats per plane.
void write_exr(const std::string& path, int width, int height, const std::vector<Plane>& planes);

}  // namespace fairlight

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <png.h>

#include <fairlight/render/atomic_file.h>
#include <fairlight/render/picture.h>
#include <fairlight/render/raster.h>

namespace fairlight {
namespace {

// The 8-bit sRGB encoding, IEC 61966-2-1. Clips at 1, as a screen shows no more; the EXR holds the
// unclipped radiance.
png_byte encode(double radiance) {
  const double shown = std::min(radiance, 1.0);
  const double curve = shown <= 0.0031308 ? 12.92 * shown : 1.055 * std::pow(shown, 1 / 2.4) - 0.055;
  return static_cast<png_byte>(std::lround(255 * curve));
}

std::vector<png_byte> encode(const Film& film) {
  std::vector<png_byte> bytes;
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      for (double radiance : film.mean(x, y)) bytes.push_back(encode(radiance));
    }
  }
  return bytes;
}

}  // namespace

void write_png(const std::string& path, const Film& film) {
  write_png(path, film.width(), film.height(), encode(film));
}

void write_png(const std::string& path, int width, int height, std::span<const std::uint8_t> rgb) {
  if (width < 1 || height < 1 ||
      rgb.size() != 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
    throw std::invalid_argument("a raster has three bytes a pixel");
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::vector<char> bytes(size);
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, rgb.data(), 0, nullptr) == 0) {
    throw std::runtime_error("cannot encode \"" + path + "\" (" + image.message + ")");
  }
  write_whole(path, {bytes.data(), size});
}

}  // namespace fairlight

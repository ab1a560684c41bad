#include <algorithm>
#include <cmath>

#include <fairlight/render/raster.h>
#include <fairlight/validation/report/canvas.h>
#include <fairlight/validation/report/letters.h>

namespace fairlight {

Canvas::Canvas(int width, int height) : width_(width), height_(height) {
  bytes_.assign(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255);
}

Colour Canvas::at(int x, int y) const {
  const auto i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x));
  return {bytes_[i], bytes_[i + 1], bytes_[i + 2]};
}

void Canvas::rectangle(int left, int top, int right, int bottom, Colour colour) {
  for (int y = std::max(top, 0); y < std::min(bottom, height_); ++y) {
    for (int x = std::max(left, 0); x < std::min(right, width_); ++x) {
      std::ranges::copy(colour, bytes_.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * width_ + x));
    }
  }
}

void Canvas::line(double x0, double y0, double x1, double y1, Colour colour) {
  const int steps = static_cast<int>(std::ceil(std::max({std::abs(x1 - x0), std::abs(y1 - y0), 1.0})));
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const int x = static_cast<int>(std::lround(x0 + t * (x1 - x0)));
    const int y = static_cast<int>(std::lround(y0 + t * (y1 - y0)));
    rectangle(x, y, x + 2, y + 2, colour);
  }
}

void Canvas::dashes(int left, int right, int y, Colour colour) {
  for (int x = left; x < right; x += 10) rectangle(x, y, std::min(x + 5, right), y + 2, colour);
}

// A dot of a letter is two pixels wide and two pixels high.
void Canvas::text(int left, int top, const std::string& words, Colour colour) {
  for (char c : words) {
    const auto& columns = letters[c >= ' ' && c <= '~' ? static_cast<std::size_t>(c - ' ') : 0];
    for (int column = 0; column < 5; ++column) {
      for (int row = 0; row < 8; ++row) {
        if ((columns[static_cast<std::size_t>(column)] >> row & 1) == 0) continue;
        const int x = left + 2 * column;
        const int y = top + 2 * row;
        rectangle(x, y, x + 2, y + 2, colour);
      }
    }
    left += letter_width;
  }
}

void Canvas::text_to(int right, int top, const std::string& words, Colour colour) {
  text(right - letter_width * static_cast<int>(words.size()), top, words, colour);
}

void Canvas::write(const std::string& path) const { write_png(path, width_, height_, bytes_); }

}  // namespace fairlight

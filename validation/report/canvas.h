#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace fairlight {

using Colour = std::array<std::uint8_t, 3>;

/// A white image to draw charts on. Drawing outside it has no effect. Coordinates are in pixels
/// from the top left.
class Canvas {
 public:
  static constexpr int letter_width = 12;
  static constexpr int letter_height = 14;

  Canvas(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  Colour at(int x, int y) const;

  void rectangle(int left, int top, int right, int bottom,
                 Colour colour);  ///< includes left and top, excludes right and bottom
  void line(double x0, double y0, double x1, double y1, Colour colour);  ///< two pixels wide
  void dashes(int left, int right, int y, Colour colour);
  void text(int left, int top, const std::string& words, Colour colour = {0, 0, 0});
  void text_to(int right, int top, const std::string& words, Colour colour = {0, 0, 0});  ///< ends at `right`

  /// Writes a PNG, whole or not at all. Throws std::runtime_error if it cannot.
  void write(const std::string& path) const;

 private:
  int width_, height_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace fairlight

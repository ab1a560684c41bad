#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fairlight/validation/checks/picture_cells.h>

namespace fairlight {
namespace {

constexpr std::size_t most_tiles = 65536;

int parts_of(int length, int tile) { return std::max(1, static_cast<int>(std::lround(double(length) / tile))); }

int begin_of(int part, int parts, int length) {
  return static_cast<int>(static_cast<long long>(part) * length / parts);
}

std::vector<std::size_t> parts_along(int length, int parts) {
  std::vector<std::size_t> part_of(static_cast<std::size_t>(length));
  for (int part = 0; part < parts; ++part) {
    for (int i = begin_of(part, parts, length); i < begin_of(part + 1, parts, length); ++i)
      part_of[static_cast<std::size_t>(i)] = static_cast<std::size_t>(part);
  }
  return part_of;
}

}  // namespace

PictureCells::PictureCells(const PixelWindow& region, int tile) : region_(region) {
  const int width = region.width(), height = region.height();
  if (width < 1 || height < 1) throw std::invalid_argument("the region to compare is empty (give another --crop)");
  if (tile == 0) tile = std::max(1, (std::max(width, height) + 7) / 8);
  columns_ = parts_of(width, tile);
  rows_ = parts_of(height, tile);
  border_ = std::min(border_width, std::min(width, height) / 4);
  if (tiles() > most_tiles) {
    throw std::invalid_argument(std::to_string(tiles()) +
                                " tiles (at most 65536 can be compared: give a larger --tile)");
  }
  tile_of_column_ = parts_along(width, columns_);
  tile_of_row_ = parts_along(height, rows_);
}

std::size_t PictureCells::tile_at(int x, int y) const {
  return tile_of_row_[static_cast<std::size_t>(y)] * static_cast<std::size_t>(columns_) +
         tile_of_column_[static_cast<std::size_t>(x)];
}

bool PictureCells::in_border(int x, int y) const {
  return std::min({x, y, region_.width() - 1 - x, region_.height() - 1 - y}) < border_;
}

PixelWindow PictureCells::tile_window(std::size_t tile) const {
  const int column = static_cast<int>(tile) % columns_, row = static_cast<int>(tile) / columns_;
  return {region_.x0 + begin_of(column, columns_, region_.width()),
          region_.y0 + begin_of(row, rows_, region_.height()),
          region_.x0 + begin_of(column + 1, columns_, region_.width()),
          region_.y0 + begin_of(row + 1, rows_, region_.height())};
}

double PictureCells::pixels(std::size_t cell) const {
  const auto area = [](int width, int height) { return static_cast<double>(width) * height; };
  const double all = area(region_.width(), region_.height());
  if (cell < channels) return all;
  if (cell < 2 * channels) return all - area(region_.width() - 2 * border_, region_.height() - 2 * border_);
  const PixelWindow window = tile_window(cell / channels - 2);
  return area(window.width(), window.height());
}

}  // namespace fairlight

#pragma once

#include <vector>

#include <fairlight/render/picture_file.h>
#include <fairlight/stats/welch.h>

namespace fairlight {

/// The cells of a picture whose means are compared: the whole, its border, and tiles of nearly
/// equal size that cover it. Each cell is one of three channels.
class PictureCells {
 public:
  static constexpr int border_width = 8;  ///< pixels, or a quarter of the shorter side if less
  static constexpr std::size_t channels = 3;

  /// `tile` is the side of a tile in pixels, about; 0 for an eighth of the longer side. Throws
  /// std::invalid_argument for an empty region or more than 65536 tiles.
  PictureCells(const PixelWindow& region, int tile);

  const PixelWindow& region() const { return region_; }
  std::size_t tiles() const { return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_); }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  std::size_t size() const { return channels * (2 + tiles()); }

  std::size_t whole(std::size_t channel) const { return channel; }
  std::size_t border(std::size_t channel) const { return channels + channel; }
  std::size_t tile(std::size_t tile, std::size_t channel) const { return channels * (2 + tile) + channel; }

  /// The tile and whether the border hold a pixel, given from the region's corner.
  std::size_t tile_at(int x, int y) const;
  bool in_border(int x, int y) const;
  PixelWindow tile_window(std::size_t tile) const;
  /// The number of pixels of a cell.
  double pixels(std::size_t cell) const;

 private:
  PixelWindow region_;
  int columns_, rows_, border_;
  std::vector<std::size_t> tile_of_column_, tile_of_row_;
};

/// What the pictures of one side of a comparison say of each cell.
struct SideOfCells {
  /// means[f][cell] of picture f.
  std::vector<std::vector<double>> means;
  /// Each cell's mean over the pictures. The variance is that between the pictures' means, or
  /// comes from their error layers. The skewness is that of a lognormal law for each pixel.
  std::vector<EstimatedMean> estimates;
  /// The most that rounding in the files can have moved each cell's mean. Pixels whose noise
  /// exceeds the step of their numbers are rounded up as often as down, and count nothing.
  std::vector<double> rounding;
  bool from_error_layer = false;  ///< else the variance is that between pictures
};

}  // namespace fairlight

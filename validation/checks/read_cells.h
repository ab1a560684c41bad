#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <fairlight/render/parallel.h>
#include <fairlight/validation/checks/picture_cells.h>

namespace fairlight {

/// Options of reading.
struct CellOptions {
  std::string layer = {};                ///< the colour to compare, where a file has several
  std::optional<PixelWindow> crop = {};  ///< the region; without it all data windows must be equal
  int tile = 0;                          ///< see PictureCells
  std::optional<double> samples = {};    ///< a pixel, where a single file does not say
  bool by_pictures = false;              ///< takes the variance from several pictures even if they are fairlight's
  double filter_radius = 0.5;            ///< of single files, in pixels: see docs/compare.md
};

struct ComparedCells {
  PictureCells cells;
  SideOfCells a, b;
  std::array<std::string, 3> channels;
};

/// Reads both sides, a few rows of all files at a time. Throws std::runtime_error, with the file's
/// name, for: a file that PictureFile refuses; pictures of different windows, channels or
/// primaries; NaN or infinite pixels, which it counts; a single file on a side without an error
/// layer; and pictures that are not independent: a file given twice, equal pixels, or common
/// samples.
ComparedCells read_cells(const std::vector<std::string>& a, const std::vector<std::string>& b,
                         const CellOptions& options, const Progress& progress = {});

}  // namespace fairlight

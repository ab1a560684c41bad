#pragma once

#include <optional>
#include <string>
#include <vector>

#include <fairlight/validation/checks/picture_cells.h>

namespace fairlight {

/// How noisy the pixels of one side's pictures are.
struct PixelNoise {
  bool half = false;  ///< whether a picture is stored in half floats
  /// Where the variance of pixels comes from: `none` for the spread of several pictures.
  ErrorLayer error_layer = ErrorLayer::none;
  std::optional<double> samples = {};  ///< a pixel, where no layer says
  double samples_per_draw = 1;         ///< above 1 where samples of a pixel come in dependent sets
  double filter_radius = 0.5;          ///< of pictures with an error layer [pixels]
};

/// Adds up one side's pictures, rows at a time, into SideOfCells.
class SideSums {
 public:
  /// Refers to `cells`.
  SideSums(const PictureCells& cells, std::size_t pictures, const PixelNoise& noise);

  /// Adds rows of all pictures: one block for each, of the same window. With an error layer, throws
  /// std::domain_error for a pixel of fewer than two samples or without a finite variance.
  void add(const PixelWindow& rows, const std::vector<PixelBlock>& pictures);

  SideOfCells finish() &&;

 private:
  struct Pixel {
    double mean, variance, degrees, deviation;
  };

  void add_pixel(const std::vector<PixelBlock>& pictures, std::size_t i, std::size_t channel, int x, int y);
  void add_to_cell(std::size_t cell, const Pixel& pixel);
  static Pixel over_pictures(const std::vector<PixelBlock>& pictures, std::size_t i, std::size_t channel);
  Pixel over_samples(const std::vector<PixelBlock>& pictures, std::size_t i, std::size_t channel, int x,
                     int y) const;
  double correlated_pixels() const;
  EstimatedMean estimate(std::size_t cell) const;

  const PictureCells& cells_;
  PixelNoise noise_;
  std::vector<std::vector<double>> means_;
  // Sums over the pixels of each cell.
  std::vector<double> variance_, variance_by_degrees_, skew_, magnitude_, rounding_;
};

}  // namespace fairlight

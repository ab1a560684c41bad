#pragma once

#include <vector>

#include <fairlight/validation/checks/picture_cells.h>

namespace fairlight {

/// The mean of a picture in which bright tiles weigh less, so that the noise of a luminaire's edge
/// does not hide a difference elsewhere. It has the same expectation for all unbiased estimates of
/// an image, as the plain mean has.
class BalancedMean {
 public:
  /// Weights a tile by its area, divided by the ratio of its mean to that of the median tile, if
  /// that is above 1. The ratio is rounded to a power of 2: weights that followed the noise would
  /// make the mean biased.
  BalancedMean(const PictureCells& cells, const SideOfCells& a, const SideOfCells& b);

  /// Of one picture, whose means of cells are given.
  double of(const std::vector<double>& means, std::size_t channel) const;
  /// Of a side: over its pictures, or of one picture with independent tiles.
  EstimatedMean of(const SideOfCells& side, std::size_t channel) const;
  double rounding(const SideOfCells& side, std::size_t channel) const;

 private:
  const PictureCells& cells_;
  std::vector<double> weights_;  // [3 tile + channel]; those of a channel sum to 1
};

}  // namespace fairlight

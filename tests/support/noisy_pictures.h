#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <fairlight/validation/checks/compare_cells.h>
#include <fairlight/validation/checks/side_sums.h>

namespace fairlight::testing {

/// Pictures in memory whose pixels are means of samples with an exponential law, as of a renderer
/// with a bright, rarely met light. Channels and pixels have different means; one pixel is a
/// luminaire.
struct NoisyPictures {
  int width = 24, height = 24;
  double luminaire = 100;    ///< times as bright as a pixel
  bool wide_filter = false;  ///< a filter of 5 x 5 pixels, by which pixels depend on each other
  bool grey = false;         ///< green and blue are as red
  int noisy_columns = 1000;  ///< the columns from here on have no noise

  PixelWindow region() const { return {0, 0, width, height}; }

  double mean(int x, int y, std::size_t c) const {
    return (x == 9 && y == 3 ? luminaire : 1) * (0.2 + 0.02 * x + 0.01 * y * static_cast<double>(c));
  }

  /// A picture of so many samples a pixel, with their standard errors. `factor(x, y)` multiplies
  /// its expectation.
  template <class Factor>
  PixelBlock draw(std::mt19937_64& generator, int samples, const Factor& factor) const {
    PixelBlock block;
    std::gamma_distribution<> sum(samples);
    for (std::size_t c = 0; c < 3; ++c) {
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          const double value = x < noisy_columns ? sum(generator) / samples : 1;
          block.colour[c].push_back(static_cast<float>(mean(x, y, c) * factor(x, y) * value));
          block.error[c].push_back(static_cast<float>(mean(x, y, c) / std::sqrt(samples)));
        }
      }
      if (grey) block.colour[c] = block.colour[0];
      if (wide_filter) block.colour[c] = filtered(block.colour[c]);
    }
    block.samples.assign(block.colour[0].size(), static_cast<float>(samples));
    return block;
  }

  /// One side: a picture for each number of samples.
  template <class Factor>
  SideOfCells side(const PictureCells& cells, std::mt19937_64& generator, const std::vector<int>& samples,
                   const Factor& factor, ErrorLayer layer = ErrorLayer::none) const {
    std::vector<PixelBlock> pictures;
    for (int n : samples) pictures.push_back(draw(generator, n, factor));
    SideSums sums(cells, pictures.size(), {.error_layer = layer});
    sums.add(region(), pictures);
    return std::move(sums).finish();
  }

 private:
  std::vector<float> filtered(const std::vector<float>& plane) const {
    constexpr float kernel[] = {1.f / 16, 4.f / 16, 6.f / 16, 4.f / 16, 1.f / 16};
    const auto at = [&](const std::vector<float>& values, int x, int y) {
      return values[static_cast<std::size_t>(std::clamp(y, 0, height - 1) * width + std::clamp(x, 0, width - 1))];
    };
    std::vector<float> rows(plane.size()), both(plane.size());
    for (int pass = 0; pass < 2; ++pass) {
      std::vector<float>& to = pass == 0 ? rows : both;
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          float sum = 0;
          for (int k = -2; k <= 2; ++k)
            sum += kernel[k + 2] * (pass == 0 ? at(plane, x + k, y) : at(rows, x, y + k));
          to[static_cast<std::size_t>(y * width + x)] = sum;
        }
      }
    }
    return both;
  }
};

inline double unchanged(int, int) { return 1; }

}  // namespace fairlight::testing

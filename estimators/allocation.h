#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fairlight/estimators/packet.h>
#include <fairlight/stats/moments.h>

namespace fairlight {

/// How many samples each pixel of an image gets out of a budget: scores say how much a pixel wants, `share_out`
/// makes counts of them, and a form (allocation_unbiased.h, allocation_naive.h) decides what becomes of the samples
/// that the scores were made from.
///
/// A pixel's samples come from `draw(pixel, first, n)`, which gives those with the numbers first, ..., first + n - 1
/// (pixel_draws.h): a function of the three alone. What it gives in two calls is independent, so an adaptive image
/// depends on no order and no thread, and a stage on no later one; the samples of one call may depend on each
/// other, as the points of a set do. The image as a whole is one draw of a random variable: its pixels are not
/// independent of each other, and only whole images may be averaged or tested.
///
/// Scores and counts are in double only: they are whole numbers, which differ from pixel to pixel, and which a
/// rounded score would change. The draws may be made in packets, whose lanes are consecutive samples.

/// An image's size; pixel y * width + x is the x-th of row y.
class PixelGrid {
 public:
  /// Throws std::invalid_argument for an image without pixels, or of 2^32 and more.
  constexpr PixelGrid(std::size_t width, std::size_t height) : width_(width), height_(height) {
    if (width == 0 || height == 0)
      throw std::invalid_argument("an image without pixels (there is nothing to sample)");
    if (width > 0xFFFFFFFFu / height)
      throw std::invalid_argument("an image of 2^32 pixels or more (their numbers have 32 bits)");
  }

  constexpr std::size_t width() const { return width_; }
  constexpr std::size_t height() const { return height_; }
  constexpr std::size_t size() const { return width_ * height_; }

 private:
  std::size_t width_, height_;
};

/// The earlier samples of every pixel.
using PixelHistories = std::vector<Moments>;
/// How many samples every pixel gets.
using SampleCounts = std::vector<std::uint64_t>;

/// How much each pixel wants, as nonnegative numbers without a unit, from at least `needs` earlier samples of each.
template <class T>
concept AllocationScore = requires(PixelGrid grid, PixelHistories histories) {
  { T::needs } -> std::convertible_to<std::uint64_t>;
  { T::of(grid, histories) } -> std::same_as<std::vector<double>>;
};

/// Every pixel alike. Source: elementary.
struct UniformAllocation {
  static constexpr std::uint64_t needs = 0;
  static std::vector<double> of(const PixelGrid& grid, const PixelHistories&) {
    return std::vector<double>(grid.size(), 1.0);
  }
};

/// In proportion to the standard deviation of the pixel's samples, which gives the least error of the image where
/// it is known. Source: Neyman 1934, "On the two different aspects of the representative method".
struct AllocationByDeviation {
  static constexpr std::uint64_t needs = 2;
  static std::vector<double> of(const PixelGrid&, const PixelHistories& histories) {
    std::vector<double> scores;
    for (const Moments& history : histories) scores.push_back(std::sqrt(history.variance()));
    return scores;
  }
};

/// In proportion to the variance of the pixel's samples.
/// Source: the paper, 3.2.2 ("probability proportional to the variance of the previous samples").
struct AllocationByVariance {
  static constexpr std::uint64_t needs = 2;
  static std::vector<double> of(const PixelGrid&, const PixelHistories& histories) {
    std::vector<double> scores;
    for (const Moments& history : histories) scores.push_back(history.variance());
    return scores;
  }
};

/// In proportion to the contrast of the pixel with those around it, up to eight: the mean of |m_i - m_j| over them,
/// m being the means so far. Source: the paper, 3.2.2 ("how similar the current value at a pixel is to those that
/// surround it").
struct AllocationByNeighbours {
  static constexpr std::uint64_t needs = 1;
  static std::vector<double> of(const PixelGrid& grid, const PixelHistories& histories) {
    std::vector<double> scores;
    for (std::size_t pixel = 0; pixel < grid.size(); ++pixel) scores.push_back(contrast(grid, histories, pixel));
    return scores;
  }

 private:
  static double contrast(const PixelGrid& grid, const PixelHistories& histories, std::size_t pixel) {
    const std::size_t x = pixel % grid.width();
    const std::size_t y = pixel / grid.width();
    double sum = 0;
    int neighbours = 0;
    for (std::size_t row = y - (y > 0); row <= std::min(y + 1, grid.height() - 1); ++row) {
      for (std::size_t column = x - (x > 0); column <= std::min(x + 1, grid.width() - 1); ++column) {
        const std::size_t other = row * grid.width() + column;
        if (other == pixel) continue;
        sum += std::abs(histories[pixel].mean() - histories[other].mean());
        ++neighbours;
      }
    }
    return neighbours == 0 ? 0 : sum / neighbours;
  }
};

namespace detail {

/// Scores as whole numbers, the largest being 2^53, so that shares of them are exact; all alike where all are zero.
inline std::vector<std::uint64_t> whole_weights(const std::vector<double>& scores) {
  double largest = 0;
  for (double score : scores) {
    if (!all_nonnegative(score)) {
      throw std::invalid_argument("a score of " + std::to_string(score) + " (it must be finite and not negative)");
    }
    largest = std::max(largest, score);
  }
  std::vector<std::uint64_t> weights;
  for (double score : scores) {
    weights.push_back(largest == 0 ? 1 : static_cast<std::uint64_t>(score / largest * 0x1p53));
  }
  return weights;
}

}  // namespace detail

/// `least` samples for every pixel, and the rest of the budget in proportion to the scores, to whole samples by the
/// largest remainders, the first pixel winning a tie. The counts sum to the budget exactly.
/// Throws std::invalid_argument for no scores, one that is negative, infinite or not a number, or a budget below
/// `least` for each.
/// Source: Hamilton's method; Balinski and Young 1982, "Fair Representation"
inline SampleCounts share_out(std::uint64_t budget, const std::vector<double>& scores, std::uint64_t least) {
  if (scores.empty()) throw std::invalid_argument("a budget for no pixels (give at least one score)");
  if (budget / scores.size() < least) {
    throw std::invalid_argument("a budget of " + std::to_string(budget) + " samples (" +
                                std::to_string(scores.size()) + " pixels need " + std::to_string(least) + " each)");
  }
  __extension__ using Wide = unsigned __int128;  // holds a budget times a weight
  const auto weights = detail::whole_weights(scores);
  const std::uint64_t rest = budget - least * scores.size();
  const Wide sum = std::accumulate(weights.begin(), weights.end(), Wide{0});
  SampleCounts counts;
  std::vector<std::pair<Wide, std::size_t>> remainders;
  std::uint64_t left = rest;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const Wide quota = Wide{rest} * weights[i];
    const auto whole = static_cast<std::uint64_t>(quota / sum);
    counts.push_back(least + whole);
    remainders.emplace_back(quota % sum, i);
    left -= whole;
  }
  std::ranges::stable_sort(remainders, std::ranges::greater{}, &std::pair<Wide, std::size_t>::first);
  for (std::size_t k = 0; k < left; ++k) ++counts[remainders[k].second];
  return counts;
}

}  // namespace fairlight

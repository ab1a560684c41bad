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

/// Splits a budget of samples between the pixels of an image. A score says how much a pixel wants,
/// and `share_out` turns the scores into sample counts. A form (allocation_unbiased.h,
/// allocation_naive.h) decides whether the samples that made the scores count in the image.
/// `draw(pixel, first, n)` gives a pixel's samples number first, ..., first + n - 1
/// (pixel_draws.h). The pixels of an adaptive image are not independent: only whole images may be
/// averaged or tested.
// `draw` is a function of its three arguments alone, so the image does not depend on order or
// threads. Two calls give independent samples; the samples of one call may depend on each other, as
// the points of a set do. Scores and counts are in double, as rounding a score would change a
// count. The draws may be made in packets, whose lanes are consecutive samples.

/// The size of an image. Pixel y * width + x is pixel x of row y.
class PixelGrid {
 public:
  /// Throws std::invalid_argument for an image with no pixels, or with 2^32 or more.
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

/// The moments of the samples that each pixel has so far.
using PixelHistories = std::vector<Moments>;
/// The number of samples for each pixel.
using SampleCounts = std::vector<std::uint64_t>;

/// How much each pixel wants: nonnegative numbers without a unit. Each pixel has at least `needs`
/// earlier samples.
template <class T>
concept AllocationScore = requires(PixelGrid grid, PixelHistories histories) {
  { T::needs } -> std::convertible_to<std::uint64_t>;
  { T::of(grid, histories) } -> std::same_as<std::vector<double>>;
};

/// All pixels get the same score. Source: elementary.
struct UniformAllocation {
  static constexpr std::uint64_t needs = 0;
  static std::vector<double> of(const PixelGrid& grid, const PixelHistories&) {
    return std::vector<double>(grid.size(), 1.0);
  }
};

/// The score is the standard deviation of the pixel's samples. If it were known exactly, it would
/// give the least error of the image.
/// Source   Neyman 1934, "On the two different aspects of the representative method"
struct AllocationByDeviation {
  static constexpr std::uint64_t needs = 2;
  static std::vector<double> of(const PixelGrid&, const PixelHistories& histories) {
    std::vector<double> scores;
    for (const Moments& history : histories) scores.push_back(std::sqrt(history.variance()));
    return scores;
  }
};

/// The score is the variance of the pixel's samples.
/// Source   the paper, 3.2.2 ("probability proportional to the variance of the previous samples")
struct AllocationByVariance {
  static constexpr std::uint64_t needs = 2;
  static std::vector<double> of(const PixelGrid&, const PixelHistories& histories) {
    std::vector<double> scores;
    for (const Moments& history : histories) scores.push_back(history.variance());
    return scores;
  }
};

/// The score is the contrast of the pixel with its neighbours, of which there are up to eight: the
/// mean of |m_i - m_j| over the neighbours j, where m is the mean so far.
/// Source   the paper, 3.2.2 ("how similar the current value at a pixel is to those that surround
///          it")
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

/// Scales the scores to integers, the largest to 2^53, so that shares of them are exact. If all
/// scores are 0, all weights are 1.
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

/// Gives each pixel `least` samples, and shares the rest of the budget in proportion to the scores.
/// Rounds to integers by the largest remainders; the first pixel wins a tie. The counts sum to the
/// budget exactly.
/// Throws std::invalid_argument if there are no scores, if a score is negative, infinite or NaN, or
/// if the budget is below `least` per pixel.
/// Source   Hamilton's method; Balinski and Young 1982, "Fair Representation"
inline SampleCounts share_out(std::uint64_t budget, const std::vector<double>& scores, std::uint64_t least) {
  if (scores.empty()) throw std::invalid_argument("a budget for no pixels (give at least one score)");
  if (budget / scores.size() < least) {
    throw std::invalid_argument("a budget of " + std::to_string(budget) + " samples (" +
                                std::to_string(scores.size()) + " pixels need " + std::to_string(least) + " each)");
  }
  __extension__ using Wide = unsigned __int128;  // holds the product of a budget and a weight
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

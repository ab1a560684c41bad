#include <algorithm>
#include <cmath>

#include <fairlight/validation/checks/balanced_mean.h>

namespace fairlight {
namespace {

constexpr std::size_t channels = PictureCells::channels;

double power_of_two(double ratio) { return ratio > 1 ? std::exp2(std::round(std::log2(ratio))) : 1; }

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

BalancedMean::BalancedMean(const PictureCells& cells, const SideOfCells& a, const SideOfCells& b)
    : cells_(cells), weights_(channels * cells.tiles()) {
  for (std::size_t c = 0; c < channels; ++c) {
    std::vector<double> means;
    for (std::size_t t = 0; t < cells.tiles(); ++t)
      means.push_back(std::abs(a.estimates[cells.tile(t, c)].mean + b.estimates[cells.tile(t, c)].mean));
    const double typical = median(means);
    double sum = 0;
    for (std::size_t t = 0; t < cells.tiles(); ++t) {
      const double ratio = typical > 0 ? means[t] / typical : 1;
      sum += weights_[channels * t + c] = cells.pixels(cells.tile(t, c)) / power_of_two(ratio);
    }
    for (std::size_t t = 0; t < cells.tiles(); ++t) weights_[channels * t + c] /= sum;
  }
}

double BalancedMean::of(const std::vector<double>& means, std::size_t channel) const {
  double sum = 0;
  for (std::size_t t = 0; t < cells_.tiles(); ++t)
    sum += weights_[channels * t + channel] * means[cells_.tile(t, channel)];
  return sum;
}

EstimatedMean BalancedMean::of(const SideOfCells& side, std::size_t channel) const {
  EstimatedMean result;
  double variance = 0, by_degrees = 0, third = 0;  // of a sum of independent tiles
  for (std::size_t t = 0; t < cells_.tiles(); ++t) {
    const EstimatedMean& tile = side.estimates[cells_.tile(t, channel)];
    const double weight = weights_[channels * t + channel], part = weight * weight * tile.squared_error;
    result.mean += weight * tile.mean;
    if (part == 0) continue;
    variance += part;
    by_degrees += part * part / tile.degrees;
    third += tile.skewness * std::pow(part, 1.5);
  }
  if (variance > 0) result.skewness = third / std::pow(variance, 1.5);
  const auto n = static_cast<double>(side.means.size());
  result.squared_error = variance;
  result.degrees = variance > 0 ? variance * variance / by_degrees : static_cast<double>(cells_.tiles());
  if (side.from_error_layer) return result;
  result.squared_error = 0;
  result.degrees = n - 1;
  for (const auto& means : side.means)
    result.squared_error += std::pow(of(means, channel) - result.mean, 2) / (n * (n - 1));
  return result;
}

double BalancedMean::rounding(const SideOfCells& side, std::size_t channel) const {
  return of(side.rounding, channel);
}

}  // namespace fairlight

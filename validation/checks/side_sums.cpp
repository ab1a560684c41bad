#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <fairlight/stats/text.h>
#include <fairlight/validation/checks/side_sums.h>

namespace fairlight {
namespace {

// The variance of a pixel's mean of n samples, from what the error layer holds.
double variance_of_mean(ErrorLayer layer, double error, double mean, double n) {
  switch (layer) {
    case ErrorLayer::standard_error:
      return error * error;
    case ErrorLayer::variance:
      return error / n;
    case ErrorLayer::second_moment: {
      // Where nothing varies, the difference of two floats may round to either side of 0.
      const double rounded = error * 0x1p-20, square = error - mean * mean;
      return std::abs(square) <= rounded ? 0 : square / (n - 1);
    }
    case ErrorLayer::none:
      break;
  }
  throw std::logic_error("there is no error layer");
}

}  // namespace

SideSums::SideSums(const PictureCells& cells, std::size_t pictures, const PixelNoise& noise)
    : cells_(cells),
      noise_(noise),
      means_(pictures, std::vector<double>(cells.size())),
      variance_(cells.size()),
      variance_by_degrees_(cells.size()),
      skew_(cells.size()),
      magnitude_(cells.size()),
      rounding_(cells.size()) {}

void SideSums::add(const PixelWindow& rows, const std::vector<PixelBlock>& pictures) {
  for (std::size_t channel = 0; channel < PictureCells::channels; ++channel) {
    std::size_t i = 0;
    for (int y = rows.y0; y < rows.y1; ++y) {
      for (int x = rows.x0; x < rows.x1; ++x) add_pixel(pictures, i++, channel, x, y);
    }
  }
}

void SideSums::add_pixel(const std::vector<PixelBlock>& pictures, std::size_t i, std::size_t channel, int x,
                         int y) {
  const int column = x - cells_.region().x0, row = y - cells_.region().y0;
  const std::array<std::size_t, 3> cells{cells_.whole(channel), cells_.tile(cells_.tile_at(column, row), channel),
                                         cells_.border(channel)};
  const std::size_t count = cells_.in_border(column, row) ? 3 : 2;
  const Pixel pixel = noise_.error_layer == ErrorLayer::none ? over_pictures(pictures, i, channel)
                                                             : over_samples(pictures, i, channel, x, y);
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t f = 0; f < pictures.size(); ++f) means_[f][cells[k]] += double{pictures[f].colour[channel][i]};
    add_to_cell(cells[k], pixel);
  }
}

void SideSums::add_to_cell(std::size_t cell, const Pixel& pixel) {
  variance_[cell] += pixel.variance;
  variance_by_degrees_[cell] += pixel.variance * pixel.variance / pixel.degrees;
  if (pixel.variance > 0) skew_[cell] += pixel.variance * pixel.variance / std::abs(pixel.mean);
  magnitude_[cell] += std::abs(pixel.mean);
  // The step of half floats, and 16 steps of floats, in which renderers add.
  const double magnitude = std::abs(pixel.mean);
  const double step = noise_.half ? std::max(magnitude * 0x1p-10, 0x1p-24) : magnitude * 0x1p-19;
  if (pixel.deviation < step) rounding_[cell] += step / 2;
}

SideSums::Pixel SideSums::over_pictures(const std::vector<PixelBlock>& pictures, std::size_t i,
                                        std::size_t channel) {
  const auto n = static_cast<double>(pictures.size());
  double mean = 0, squares = 0;
  for (const PixelBlock& picture : pictures) mean += double{picture.colour[channel][i]} / n;
  for (const PixelBlock& picture : pictures) squares += std::pow(double{picture.colour[channel][i]} - mean, 2);
  const double variance = squares / (n - 1);
  return {mean, variance / n, n - 1, std::sqrt(variance)};
}

SideSums::Pixel SideSums::over_samples(const std::vector<PixelBlock>& pictures, std::size_t i, std::size_t channel,
                                       int x, int y) const {
  const auto pictures_count = static_cast<double>(pictures.size());
  double sum = 0, variance = 0, by_degrees = 0;
  for (const PixelBlock& picture : pictures) {
    const double mean = double{picture.colour[channel][i]}, error = double{picture.error[channel][i]};
    const double samples = picture.samples.empty() ? noise_.samples.value_or(0) : double{picture.samples[i]};
    const double n = samples / noise_.samples_per_draw;
    const double of_picture = variance_of_mean(noise_.error_layer, error, mean, n);
    if (!(std::isfinite(of_picture) && of_picture >= 0 && n >= 2)) {
      throw std::domain_error(formatted(
          "no usable error at pixel (%d, %d) (a pixel needs two samples, or sets of them, and a finite error)", x,
          y));
    }
    sum += mean;
    variance += of_picture;
    by_degrees += of_picture * of_picture / (n - 1);
  }
  const double degrees = variance > 0 ? variance * variance / by_degrees : 1;
  return {sum / pictures_count, variance / (pictures_count * pictures_count), degrees,
          std::sqrt(variance / pictures_count)};
}

// The number of pixels whose filters overlap that of one pixel: the variance of a sum of pixels is
// at most so many times the sum of their variances.
double SideSums::correlated_pixels() const {
  const double reach = std::ceil(2 * noise_.filter_radius) - 1;
  return (2 * reach + 1) * (2 * reach + 1);
}

EstimatedMean SideSums::estimate(std::size_t cell) const {
  const double pixels = cells_.pixels(cell), variance = variance_[cell];
  const auto n = static_cast<double>(means_.size());
  EstimatedMean result;
  for (const auto& means : means_) result.mean += means[cell] / n;
  result.degrees = n - 1;
  if (noise_.error_layer != ErrorLayer::none) {
    result.squared_error = correlated_pixels() * variance / (pixels * pixels);
    result.degrees = variance > 0 ? variance * variance / variance_by_degrees_[cell] : pixels;
  } else {
    for (const auto& means : means_) result.squared_error += std::pow(means[cell] - result.mean, 2) / (n * (n - 1));
  }
  if (variance == 0) return result;
  // A lognormal law of small relative deviation has the skewness 3 s / mean. `uneven` is how much
  // larger the skewness of a sum is than if its terms had all the same ratio of variance to mean.
  const double uneven = skew_[cell] * magnitude_[cell] / (variance * variance);
  result.skewness = 3 * uneven * std::sqrt(result.squared_error) / std::abs(result.mean);
  return result;
}

SideOfCells SideSums::finish() && {
  SideOfCells side;
  side.from_error_layer = noise_.error_layer != ErrorLayer::none;
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    const double pixels = cells_.pixels(cell);
    if (pixels == 0) continue;
    for (auto& means : means_) means[cell] /= pixels;
    rounding_[cell] /= pixels;
  }
  for (std::size_t cell = 0; cell < cells_.size(); ++cell)
    side.estimates.push_back(cells_.pixels(cell) > 0 ? estimate(cell) : EstimatedMean{});
  side.rounding = std::move(rounding_);
  side.means = std::move(means_);
  return side;
}

}  // namespace fairlight

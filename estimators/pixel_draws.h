#pragma once

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fairlight/estimators/point_set.h>

namespace fairlight {

/// Where the samples of an allocated image come from (allocation.h): `draw(pixel, first, n)` from an estimator at
/// each pixel, `estimator(pixel, source)`, that takes its numbers from a source of its own for every sample.

/// From streams, every sample independent of all others; in packets a lane each. `first_unit` is the unit of pixel
/// 0, and sets images of one key apart. Source: Salmon et al. 2011.
template <class Real, class PixelEstimator>
class PixelDraws {
 public:
  PixelDraws(const StreamKey& key, std::uint32_t first_unit, PixelEstimator estimator)
      : key_(key), first_unit_(first_unit), estimator_(std::move(estimator)) {}

  /// Throws std::length_error for a pixel whose unit has more than 32 bits.
  std::vector<double> operator()(std::size_t pixel, std::uint64_t first, std::uint64_t n) const {
    const std::uint32_t unit = checked_number(first_unit_, pixel, "units");
    std::vector<double> samples;
    for (std::uint64_t i = 0; i < n; i += lanes<Real>) {
      PhiloxStream<Real> source(key_, unit, first + i);
      std::array<double, lanes<Real>> values{};
      store_lanes(estimator_(pixel, source), values.data());
      samples.insert(samples.end(), values.begin(), values.begin() + std::min<long>(lanes<Real>, long(n - i)));
    }
    return samples;
  }

 private:
  StreamKey key_;
  std::uint32_t first_unit_;
  PixelEstimator estimator_;
};

/// From point sets, in double: the samples of one call are the n points of a replicate of their
/// own, so that stages stay independent. Were one sequence continued from stage to stage, its later
/// points would depend on those that decided how many there are, and no form of allocation would be
/// unbiased. Source: Owen 1997, "Monte Carlo variance of scrambled net quadrature" (replicates).
template <PointSet Set, class PixelEstimator>
class PixelPointSets {
 public:
  /// Replicates from `first_replicate` on, `samples` for each pixel: more than the number of any sample.
  PixelPointSets(const StreamKey& key, std::uint32_t first_replicate, std::uint32_t samples,
                 PixelEstimator estimator)
      : key_(key), first_replicate_(first_replicate), samples_(samples), estimator_(std::move(estimator)) {}

  /// Throws std::length_error for sample numbers of `samples` or more, which are another pixel's, and for a replicate
  /// whose number has more than 32 bits.
  std::vector<double> operator()(std::size_t pixel, std::uint64_t first, std::uint64_t n) const {
    std::vector<double> values;
    if (n == 0) return values;
    if (first > samples_ || n > samples_ - first)
      throw std::length_error("a pixel's samples have run out (reserve more)");
    const auto points = static_cast<std::uint32_t>(n);
    const std::uint64_t replicate = std::uint64_t{checked_number(0, pixel, "pixels")} * samples_ + first;
    const Set set(key_, checked_number(first_replicate_, replicate, "replicates"), points);
    for (std::uint32_t i = 0; i < points; ++i) {
      auto source = set.source(i);
      values.push_back(estimator_(pixel, source));
    }
    return values;
  }

 private:
  StreamKey key_;
  std::uint32_t first_replicate_, samples_;
  PixelEstimator estimator_;
};

}  // namespace fairlight

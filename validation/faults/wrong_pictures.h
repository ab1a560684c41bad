#pragma once

#include <algorithm>

#include <fairlight/validation/claims/rendered_radiance.h>

/// Wrong renderers of whole pictures, in place of the shipped one.
namespace fairlight::faults {

/// Clamps samples at 100 before averaging, against "fireflies".
/// On record: the class of Smerity/montelight-cpp, which clamps at 1.
struct SamplesClampedAt100 {
  static void render(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                     Film& film) {
    for (std::uint64_t sample = range.first; sample < range.last; ++sample) {
      Film one(film.width(), film.height());
      ShippedRenderer::render(view, settings, seed, {sample, sample + 1}, one);
      for (int y = 0; y < film.height(); ++y) {
        for (int x = 0; x < film.width(); ++x) film.add(x, y, one.mean(x, y).min(100));
      }
    }
  }
};

/// Every sample of a pixel from the 65th on repeats the first 64, as a buffer of 64 is not refilled.
struct SamplesRepeatedAfter64 {
  static void render(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                     Film& film) {
    for (std::uint64_t first = range.first; first < range.last; first += 64) {
      const std::uint64_t n = std::min<std::uint64_t>(64, range.last - first);
      ShippedRenderer::render(view, settings, seed, {range.first, range.first + n}, film);
    }
  }
};

}  // namespace fairlight::faults

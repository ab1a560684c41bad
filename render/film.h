#pragma once

#include <array>
#include <exception>
#include <span>
#include <vector>

#include <fairlight/estimators/vec.h>
#include <fairlight/stats/exact_moments.h>

namespace fairlight {

/// The exact moments of the samples of each pixel and channel [W/(sr m^2)]. Parts of a pixel's
/// samples give the same film to the bit in whatever way they are split and merged: over threads,
/// resumed renders, shards or machines.
class Film {
 public:
  using Pixel = std::array<ExactMoments, 3>;

  /// Throws std::invalid_argument unless both are in 1 .. 65536.
  Film(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }

  Pixel& at(int x, int y) { return pixels_[index(x, y)]; }
  const Pixel& at(int x, int y) const { return pixels_[index(x, y)]; }

  /// Adds one sample to a pixel. Throws std::domain_error, with the pixel, when a channel is
  /// negative, NaN, or 2^64 or more.
  void add(int x, int y, const Rgb<double>& sample);

  /// Adds samples to a pixel, one list per channel. Throws as above; other channels may then have
  /// been added, each wholly or not at all.
  void add(int x, int y, const std::array<std::span<const float>, 3>& samples) { add_all(x, y, samples); }
  void add(int x, int y, const std::array<std::span<const double>, 3>& samples) { add_all(x, y, samples); }

  /// Throws std::invalid_argument when the sizes differ.
  void merge(const Film& other);

  /// The mean radiance of a pixel.
  Rgb<double> mean(int x, int y) const;

  bool operator==(const Film&) const = default;

 private:
  // Inline, so that it is compiled for the caller's instruction set.
  template <class Samples>
  void add_all(int x, int y, const Samples& samples) {
    try {
      for (std::size_t c = 0; c < 3; ++c) at(x, y)[c].add(samples[c]);
    } catch (const std::exception& error) {
      refuse(x, y, error);
    }
  }
  [[noreturn]] static void refuse(int x, int y, const std::exception& error);

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  int width_, height_;
  std::vector<Pixel> pixels_;
};

}  // namespace fairlight

#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <numeric>
#include <stdexcept>

#include <fairlight/render/tile_renderer.h>

namespace fairlight {

/// The work of a lane: a sample of a pixel, and its number among the tile's samples.
template <class Real>
struct Job {
  Word<Real> number = Word<Real>(0u), pixel = number, sample = number;
};

namespace detail {

/// One value per lane, in memory.
template <class Real, class Value>
using InLanes = std::array<Value, lanes<Real>>;

template <class Batch, class Value, std::size_t n>
Batch loaded(const std::array<Value, n>& values) {
  if constexpr (n == 1) {
    return values[0];
  } else {
    return Batch::load_unaligned(values.data());
  }
}

template <class Real, class Value, class Batch>
InLanes<Real, Value> stored(const Batch& x) {
  InLanes<Real, Value> values{};
  if constexpr (lanes<Real> == 1) {
    values[0] = x;
  } else {
    x.store_unaligned(values.data());
  }
  return values;
}

}  // namespace detail

/// Jobs for some samples of every pixel of a tile, pixel by pixel. Camera rays are made a packet at
/// a time and handed out as lanes become idle: few lanes end together, and a ray costs as much for
/// one lane as for all.
template <class Real>
class TileJobs {
 public:
  /// Samples from `first_sample` on, of an image `width` pixels wide. Throws std::length_error if
  /// 32 bits cannot number all samples and jobs.
  TileJobs(const Tile& tile, std::uint32_t first_sample, std::uint32_t samples, int width)
      : tile_(tile),
        first_sample_(first_sample),
        samples_(samples),
        jobs_(checked_jobs(tile, first_sample, samples)),
        width_(static_cast<std::uint32_t>(width)),
        x_(tile.left),
        y_(tile.top) {}

  std::uint32_t size() const { return jobs_; }

  /// Gives the next jobs to the lanes whose bits are set, the lowest first, and returns the bits of
  /// the lanes that got one; 0 when no jobs are left. `make(middle of the pixel, job)` makes the
  /// rays of a packet of jobs.
  std::uint32_t give(std::uint32_t idle, const auto& make, Ray<Real>& ray, Job<Real>& job) {
    if (next_ == end_ && made_ < jobs_) make_ready(make);
    const std::uint32_t given = lowest(idle, end_ - next_);
    if (given == 0) return 0;
    const auto take = [&](const auto& ready, auto& lanes) { lanes = expand(given, &ready[next_], lanes); };
    take(numbers_, job.number);
    take(pixels_, job.pixel);
    take(drawn_, job.sample);
    for (std::size_t i = 0; i < 3; ++i) {
      take(origins_[i], ray.origin[static_cast<Eigen::Index>(i)]);
      take(directions_[i], ray.direction[static_cast<Eigen::Index>(i)]);
    }
    next_ += static_cast<std::size_t>(std::popcount(given));
    return given;
  }

 private:
  static std::uint32_t checked_jobs(const Tile& tile, std::uint32_t first_sample, std::uint32_t samples) {
    const std::uint64_t jobs = std::uint64_t{samples} * static_cast<std::uint64_t>(tile.pixels());
    if (jobs >> 32 != 0 || std::uint64_t{first_sample} + samples > std::uint64_t{1} << 32)
      throw std::length_error("a tile of more samples than 32 bits number (take fewer at once)");
    return static_cast<std::uint32_t>(jobs);
  }

  using Number = Lane<Real>;
  using Numbers = detail::InLanes<Real, Number>;
  using Words = detail::InLanes<Real, std::uint32_t>;

  /// The lowest n set bits, or all of them if there are fewer.
  static std::uint32_t lowest(std::uint32_t bits, std::size_t n) {
    std::uint32_t rest = bits;
    for (; rest != 0 && n != 0; --n) rest &= rest - 1;
    return bits & ~rest;
  }

  void make_ready(const auto& make) {
    Numbers middle_x{}, middle_y{};
    next_ = 0;
    end_ = std::min<std::size_t>(lanes<Real>, jobs_ - made_);
    for (std::size_t i = 0; i < end_;) {
      // The jobs of this pixel.
      const std::size_t n = std::min<std::size_t>(end_ - i, samples_ - sample_);
      std::iota(&numbers_[i], &numbers_[i] + n, made_);
      std::fill_n(&pixels_[i], n, static_cast<std::uint32_t>(y_) * width_ + static_cast<std::uint32_t>(x_));
      std::iota(&drawn_[i], &drawn_[i] + n, first_sample_ + sample_);
      std::fill_n(&middle_x[i], n, static_cast<Number>(x_) + Number(0.5));
      std::fill_n(&middle_y[i], n, static_cast<Number>(y_) + Number(0.5));
      i += n;
      made_ += static_cast<std::uint32_t>(n);
      sample_ += static_cast<std::uint32_t>(n);
      if (sample_ == samples_) next_pixel();
    }
    const auto words = [](const Words& each) { return detail::loaded<Word<Real>>(each); };
    const Vec2<Real> middle(detail::loaded<Real>(middle_x), detail::loaded<Real>(middle_y));
    const Ray<Real> ray = make(middle, Job<Real>{words(numbers_), words(pixels_), words(drawn_)});
    for (std::size_t i = 0; i < 3; ++i) {
      origins_[i] = detail::stored<Real, Number>(ray.origin[static_cast<Eigen::Index>(i)]);
      directions_[i] = detail::stored<Real, Number>(ray.direction[static_cast<Eigen::Index>(i)]);
    }
  }

  void next_pixel() {
    sample_ = 0;
    if (++x_ < tile_.right) return;
    x_ = tile_.left;
    ++y_;
  }

  Tile tile_;
  std::uint32_t first_sample_, samples_;  ///< of every pixel
  std::uint32_t jobs_, made_ = 0;
  std::uint32_t width_;  ///< of the image
  int x_, y_;
  std::uint32_t sample_ = 0;              ///< the next job's sample of its pixel
  Words numbers_{}, pixels_{}, drawn_{};  ///< the jobs that are ready, as in Job
  std::array<Numbers, 3> origins_{}, directions_{};
  /// The first job that is not yet given out, and the end of the ready jobs.
  std::size_t next_ = 0, end_ = 0;
};

}  // namespace fairlight

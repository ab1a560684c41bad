#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <vector>

#include <fairlight/estimators/vertex_source.h>
#include <fairlight/render/flatten.h>
#include <fairlight/render/tile_jobs.h>

namespace fairlight {

/// The sum of samples, by eight partial sums for SIMD, in the same order for every instruction set.
/// -infinity if a sample is negative or NaN.
template <class Number>
double sum_of_set(std::span<const Number> samples) {
  bool wrong = false;
  for (const Number sample : samples) wrong |= !(sample >= 0);
  if (wrong) return -infinity<double>;
  std::array<double, 8> sums{};
  for (; samples.size() >= sums.size(); samples = samples.subspan(sums.size())) {
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += static_cast<double>(samples[i]);
  }
  for (std::size_t i = 0; i < samples.size(); ++i) sums[i] += static_cast<double>(samples[i]);
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

/// The means of sets of n samples, each one draw of the film. An invalid sample makes its set's
/// mean invalid too, so that the film throws.
template <class Number>
std::vector<double> set_means(std::span<const Number> samples, std::uint32_t n) {
  std::vector<double> means;
  for (std::size_t first = 0; first < samples.size(); first += n)
    means.push_back(sum_of_set(samples.subspan(first, n)) / n);
  return means;
}

/// Traces a tile's samples as jobs, one per lane. A lane whose path has ended takes the next job.
/// The result of a job depends on its pixel and sample only, not on its lane.
template <class Real>
class TileTracer : public TileRenderer {
 public:
  explicit TileTracer(const TileSettings& settings)
      : scene_(settings.scene),
        camera_(settings.camera),
        filter_(settings.strategies.filter),
        tracer_(chosen_tracer<Real>(settings.strategies, settings.scene)),
        strategies_(settings.strategies),
        key_(settings.key),
        points_(settings.strategies.points),
        width_(settings.width),
        height_(settings.height) {}

  std::uint64_t render(const Tile& tile, SampleRange range, Film& film) const override {
    const CountedScene<Real> scene(scene_);
    const std::uint64_t at_once = std::max(held, points_);
    for (std::uint64_t first = range.first, n = 0; first < range.last; first += n) {
      // The samples left under the same key.
      const std::uint64_t of_key = (std::uint64_t{1} << 32) - (first & 0xFFFFFFFFu);
      n = std::min({at_once, range.last - first, of_key});
      Run run(*this, tile, first, static_cast<std::uint32_t>(n));
      run.trace(scene);
      for (int pixel = 0; pixel < tile.pixels(); ++pixel) run.add_pixel(pixel, film);
    }
    return scene.rays();
  }

 private:
  using Number = Lane<Real>;
  static constexpr std::uint32_t everyone = static_cast<std::uint32_t>((std::uint64_t{1} << lanes<Real>)-1);
  /// The samples kept per pixel before they are added to the film; at least one set.
  static constexpr std::uint32_t held = 64;

  /// The jobs for some samples of every pixel of a tile.
  class Run {
   public:
    Run(const TileTracer& tracer, const Tile& tile, std::uint64_t first_sample, std::uint32_t samples)
        : by_(tracer),
          numbers_(tracer.numbers_of(first_sample)),
          tile_(tile),
          samples_(samples),
          jobs_(tile, static_cast<std::uint32_t>(first_sample), samples, tracer.width_) {
      for (auto& channel : radiance_) channel = std::make_unique_for_overwrite<Number[]>(jobs_.size());
    }

    /// Advances all paths by one vertex at a time, and gives idle lanes new jobs at once.
    void trace(const CountedScene<Real>& scene) {
      Path<Real> path{{Vec3<Real>(Real(0), Real(0), Real(0)), Vec3<Real>(Real(0), Real(0), Real(1)), Real(-1)}};
      Mask<Real> alive(false);
      std::uint32_t idle = everyone;
      while (true) {
        if (idle != 0) idle = start(path, alive, idle);
        if (idle == everyone) return;
        alive = advance(scene, path, alive);
        const std::uint32_t ended = ~lane_bits(alive) & ~idle & everyone;
        if (ended != 0) finish(path, ended);
        idle |= ended;
      }
    }

    void add_pixel(int pixel, Film& film) const {
      const auto begin = static_cast<std::size_t>(pixel) * samples_;
      const auto of = [&](std::size_t c) { return std::span<const Number>(&radiance_[c][begin], samples_); };
      const int x = tile_.left + pixel % tile_.width();
      const int y = tile_.top + pixel / tile_.width();
      if (by_.points_ == 1) return film.add(x, y, std::array{of(0), of(1), of(2)});
      const std::array means{set_means(of(0), by_.points_), set_means(of(1), by_.points_),
                             set_means(of(2), by_.points_)};
      film.add(x, y, std::array<std::span<const double>, 3>{means[0], means[1], means[2]});
    }

   private:
    /// Advances all paths by one vertex.
    FAIRLIGHT_FLATTEN Mask<Real> advance(const CountedScene<Real>& scene, Path<Real>& path,
                                         const Mask<Real>& alive) {
      VertexSource<Real, ChosenNumbers> source(numbers_, {job_.pixel, job_.sample, vertex_of(path)});
      return by_.tracer_.advance(scene, path, source, alive);
    }

    /// The number of the next vertex; vertex 0 is the camera.
    static Word<Real> vertex_of(const Path<Real>& path) { return word_of(to_int(path.depth)) + Word<Real>(1u); }

    /// Gives jobs to idle lanes, and returns the lanes that are still idle.
    FAIRLIGHT_FLATTEN std::uint32_t start(Path<Real>& path, Mask<Real>& alive, std::uint32_t idle) {
      const auto ray_of = [this](const Vec2<Real>& middle, const Job<Real>& job) {
        VertexSource<Real, ChosenNumbers> source(numbers_, {job.pixel, job.sample, Word<Real>(0u)},
                                                 by_.camera_.has_lens() ? BlockPart::all : BlockPart::first_pair);
        return pixel_ray(by_.camera_, by_.filter_, middle, by_.width_, by_.height_, source);
      };
      while (idle != 0) {
        const std::uint32_t given = jobs_.give(idle, ray_of, path.ray, job_);
        if (given == 0) return idle;
        begin(path, alive, given);
        idle &= ~given;
      }
      return idle;
    }

    void begin(Path<Real>& path, Mask<Real>& alive, std::uint32_t given) {
      constexpr auto ones = [] {
        detail::InLanes<Real, Number> all{};
        all.fill(Number(1));
        return all;
      }();
      const Mask<Real> starts = expand(given, ones.data(), Real(0)) > Real(0);
      path.ray.origin_primitive = select(starts, Real(-1), path.ray.origin_primitive);
      begin_paths(path, starts);
      alive = alive || starts;
    }

    void finish(const Path<Real>& path, std::uint32_t ended) {
      // For a few lanes, a loop is faster than a scatter instruction.
      const auto jobs = detail::stored<Real, std::uint32_t>(job_.number);
      std::array<detail::InLanes<Real, Number>, 3> found;
      for (std::size_t c = 0; c < 3; ++c)
        found[c] = detail::stored<Real, Number>(path.radiance[static_cast<Eigen::Index>(c)]);
      for (; ended != 0; ended &= ended - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(ended));
        for (std::size_t c = 0; c < 3; ++c) radiance_[c][jobs[lane]] = found[c][lane];
      }
    }

    const TileTracer& by_;
    ChosenNumbers numbers_;
    Tile tile_;
    std::uint32_t samples_;  ///< of every pixel
    TileJobs<Real> jobs_;
    Job<Real> job_;                                      ///< the job of each lane
    std::array<std::unique_ptr<Number[]>, 3> radiance_;  ///< by channel and job
  };

  /// Lanes number samples by 32-bit words; the high 32 bits of a sample's number select the key.
  /// Samples below 2^32 use the render's own key, and no numbers repeat beyond.
  ChosenNumbers numbers_of(std::uint64_t sample) const {
    return {strategies_, key_.further(static_cast<std::uint32_t>(sample >> 32))};
  }

  TracedScene<Real> scene_;
  Camera camera_;
  ChosenFilter<Real> filter_;
  PathTracer<ChosenBounces, ChosenDirect<Real>, ChosenRoulette> tracer_;
  Strategies strategies_;
  StreamKey key_;
  std::uint32_t points_;  ///< points of a set
  int width_, height_;
};

}  // namespace fairlight

#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>

#include <fairlight/render/picture.h>
#include <fairlight/validation/claims/rendered_radiance.h>

namespace fairlight {

/// How a picture gets its samples.
enum class Rendering {
  at_once,
  resumed,  ///< half of the samples, and later the rest
  ranges,   ///< three shards of the samples of one seed, merged
  seeds,    ///< three shards of one seed each, merged
};

/// The size of a picture, its samples a pixel and how it gets them.
struct PicturePlan {
  int width, height;
  std::uint32_t samples = 1;
  Rendering rendering = Rendering::at_once;
};

/// Independent pictures of a view by the renderer as it is shipped: picture r has a seed of its own,
/// and its samples begin at 0, as those of a user's picture do.
template <class Renderer = ShippedRenderer>
class ReplicatePictures {
 public:
  ReplicatePictures(const View& view, const RenderSettings& settings, const PicturePlan& plan, const StreamKey& key)
      : view_(view), settings_(settings), plan_(plan), key_(key) {}

  /// Picture number r; it stays until another one is asked for. Nothing where the renderer rejects
  /// it, because of an invalid sample.
  const Film* at(std::uint64_t r) {
    if (r != number_) {
      number_ = r;
      try {
        film_ = whole(seed_of(r));
      } catch (const std::domain_error&) {
        film_.reset();
      }
    }
    return film_ ? &*film_ : nullptr;
  }

  /// The same picture of these samples of seed number `further` after its own.
  Film part(std::uint64_t r, std::uint64_t further, SampleRange range) const {
    Film film(plan_.width, plan_.height);
    Renderer::render(view_, settings_, seed_of(r) + further, range, film);
    return film;
  }

 private:
  static constexpr std::uint64_t shards = 3;

  std::uint64_t seed_of(std::uint64_t r) const {
    const auto words = key_.further(static_cast<std::uint32_t>(r)).words();
    const auto block = Philox<std::uint32_t>::draw({0, 0, 0, 0}, words);
    return std::uint64_t{block[1]} << 32 | block[0];
  }

  Film whole(std::uint64_t seed) const {
    const std::uint64_t n = plan_.samples, sets = n / settings_.points;
    if (plan_.rendering == Rendering::ranges || plan_.rendering == Rendering::seeds) return merged(seed, sets);
    Film film(plan_.width, plan_.height);
    const std::uint64_t half = plan_.rendering == Rendering::resumed ? sets / 2 * settings_.points : 0;
    if (half > 0) Renderer::render(view_, settings_, seed, {0, half}, film);
    Renderer::render(view_, settings_, seed, {half, n}, film);
    return film;
  }

  Film merged(std::uint64_t seed, std::uint64_t sets) const {
    std::optional<Picture> picture;
    for (std::uint64_t i = 0; i < shards; ++i) {
      const SampleRange range{i * sets / shards * settings_.points, (i + 1) * sets / shards * settings_.points};
      const bool of_seeds = plan_.rendering == Rendering::seeds;
      const SampleRange samples = of_seeds ? SampleRange{0, range.last - range.first} : range;
      Picture shard{settings_, {}, Film(plan_.width, plan_.height)};
      shard.samples.add(seed + (of_seeds ? i : 0), samples);
      Renderer::render(view_, settings_, seed + (of_seeds ? i : 0), samples, shard.film);
      if (picture) {
        picture->merge(shard);
      } else {
        picture = shard;
      }
    }
    return picture->film;
  }

  View view_;
  RenderSettings settings_;
  PicturePlan plan_;
  StreamKey key_;
  std::uint64_t number_ = std::numeric_limits<std::uint64_t>::max();
  std::optional<Film> film_;
};

/// The pixels of a quarter of a picture, one after another and picture by picture. Where the sides
/// are odd, the quarters share the middle column and row, so that all have as many pixels.
struct Quarter {
  int left, top, width, height;

  static Quarter of(const PicturePlan& plan, std::size_t quarter) {
    const int width = (plan.width + 1) / 2, height = (plan.height + 1) / 2;
    return {quarter % 2 == 0 ? 0 : plan.width - width, quarter / 2 == 0 ? 0 : plan.height - height, width, height};
  }
  std::uint64_t pixels() const { return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height); }
  int x(std::uint64_t draw) const { return left + static_cast<int>(draw % pixels()) % width; }
  int y(std::uint64_t draw) const { return top + static_cast<int>(draw % pixels()) / width; }
};

/// Tests that each pixel of a picture has its mean: channel 3 q + c is the quotient of the pixels of
/// quarter q and their means in channel c, which is 1 in the mean. Quotients of pixels that took
/// each other's place have a mean above 1, since r + 1/r > 2. `mean(x, y)` is what channels ought to
/// show, and no sample exceeds `largest` times that.
/// Draw i of a channel is a pixel of its own, so draws have equal means, and are independent.
template <class Renderer>
Finding test_pixels(const Trial& trial, const View& view, const RenderSettings& settings, const PicturePlan& plan,
                    const auto& mean, double largest) {
  std::vector<Rgb<double>> means;
  for (int y = 0; y < plan.height; ++y) {
    for (int x = 0; x < plan.width; ++x) means.push_back(mean(x, y));
  }
  const std::vector<Reference> references(12, Reference{1, 0, largest});
  ReplicatePictures<Renderer> pictures(view, settings, plan, StreamKey(trial.seed, trial.claim));
  const auto draws = [&](std::uint64_t first, std::vector<std::vector<double>>& channels) {
    for (std::size_t i = 0; i < channels[0].size(); ++i) {
      for (std::size_t q = 0; q < 4; ++q) {
        const Quarter quarter = Quarter::of(plan, q);
        const std::uint64_t draw = first + i;
        const Film* film = pictures.at(draw / quarter.pixels());
        const int x = quarter.x(draw), y = quarter.y(draw);
        for (std::size_t c = 0; c < 3; ++c) {
          const double of_pixel = film ? film->at(x, y)[c].mean() : std::numeric_limits<double>::quiet_NaN();
          channels[3 * q + c][i] =
              of_pixel / means[static_cast<std::size_t>(y * plan.width + x)][static_cast<Eigen::Index>(c)];
        }
      }
    }
  };
  return test_means(trial,
                    settings.real == Arithmetic::packets ? rounded_references<Packet>(references)
                                                         : rounded_references<double>(references),
                    draws);
}

}  // namespace fairlight

#pragma once

#include <cstdint>
#include <limits>
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

/// Independent pictures of a view by the renderer as it is shipped: picture r has a seed of its
/// own, and its samples begin at 0, as those of a user's picture do.
template <class Renderer = ShippedRenderer>
class ReplicatePictures {
 public:
  ReplicatePictures(const View& view, const RenderSettings& settings, const PicturePlan& plan, const StreamKey& key)
      : view_(view), settings_(settings), plan_(plan), key_(key) {}

  /// Picture number r; it stays until another one is asked for. Throws BadDraw where the renderer
  /// rejects it, because of an invalid sample.
  const Film& at(std::uint64_t r) {
    if (r != number_) {
      film_ = accepted(r, [&] { return whole(seed_of(r)); });
      number_ = r;
    }
    return film_;
  }

  /// These samples of picture r, or of one of a seed that is greater by `further`. Throws as at
  /// does.
  Film part(std::uint64_t r, std::uint64_t further, SampleRange range) const {
    return accepted(r, [&] { return rendered(seed_of(r) + further, range); });
  }

 private:
  static constexpr std::uint64_t shards = 3;

  static Film accepted(std::uint64_t r, const auto& make) {
    try {
      return make();
    } catch (const std::domain_error&) {
      throw BadDraw(r, std::numeric_limits<double>::quiet_NaN(), "of a picture with an invalid sample");
    }
  }

  std::uint64_t seed_of(std::uint64_t r) const {
    const auto words = key_.further(static_cast<std::uint32_t>(r)).words();
    const auto block = Philox<std::uint32_t>::draw({0, 0, 0, 0}, words);
    return std::uint64_t{block[1]} << 32 | block[0];
  }

  Film rendered(std::uint64_t seed, SampleRange range) const {
    Film film(plan_.width, plan_.height);
    Renderer::render(view_, settings_, seed, range, film);
    return film;
  }

  Film whole(std::uint64_t seed) const {
    const std::uint64_t n = plan_.samples;
    if (plan_.rendering == Rendering::ranges || plan_.rendering == Rendering::seeds) return merged(seed);
    if (plan_.rendering == Rendering::at_once) return rendered(seed, {0, n});
    const std::uint64_t half = n / settings_.points / 2 * settings_.points;
    Film film = rendered(seed, {0, half});
    Renderer::render(view_, settings_, seed, {half, n}, film);
    return film;
  }

  Film merged(std::uint64_t seed) const {
    const std::uint64_t sets = plan_.samples / settings_.points;
    Picture picture{settings_, {}, Film(plan_.width, plan_.height)};
    for (std::uint64_t i = 0; i < shards; ++i) {
      SampleRange range{i * sets / shards * settings_.points, (i + 1) * sets / shards * settings_.points};
      std::uint64_t of_shard = seed;
      if (plan_.rendering == Rendering::seeds) {
        range = {0, range.last - range.first};
        of_shard += i;
      }
      Picture shard{settings_, {}, rendered(of_shard, range)};
      shard.samples.add(of_shard, range);
      picture.merge(shard);
    }
    return picture.film;
  }

  View view_;
  RenderSettings settings_;
  PicturePlan plan_;
  StreamKey key_;
  std::uint64_t number_ = std::numeric_limits<std::uint64_t>::max();
  Film film_{1, 1};
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

/// The references of quotients of pixels and their means, for four quarters of three channels.
inline std::vector<Reference> quotients(Arithmetic real, double largest) {
  const std::vector<Reference> references(12, Reference{1, 0, largest});
  return real == Arithmetic::packets ? rounded_references<Packet>(references)
                                     : rounded_references<double>(references);
}

/// Tests that each pixel of a picture has its mean: channel 3 q + c is the quotient of the pixels
/// of quarter q and their means in channel c, which is 1 in the mean. Quotients of pixels that took
/// each other's place have a mean above 1, since r + 1/r > 2. `mean(x, y)` is what channels ought
/// to show, and no sample exceeds `largest` times that. Draw i of a channel is a pixel of its own,
/// so draws have equal means, and are independent.
template <class Renderer>
Finding test_pixels(const Trial& trial, const View& view, const RenderSettings& settings, const PicturePlan& plan,
                    const auto& mean, double largest) {
  std::vector<Rgb<double>> means;
  for (int y = 0; y < plan.height; ++y) {
    for (int x = 0; x < plan.width; ++x) means.push_back(mean(x, y));
  }
  ReplicatePictures<Renderer> pictures(view, settings, plan, StreamKey(trial.seed, trial.claim));
  const auto draws = [&](std::uint64_t first, std::vector<std::vector<double>>& channels) {
    for (std::size_t i = 0; i < channels[0].size(); ++i) {
      for (std::size_t q = 0; q < 4; ++q) {
        const Quarter quarter = Quarter::of(plan, q);
        const std::uint64_t draw = first + i;
        const int x = quarter.x(draw), y = quarter.y(draw);
        const Rgb<double> quotient =
            pictures.at(draw / quarter.pixels()).mean(x, y) / means[static_cast<std::size_t>(y * plan.width + x)];
        for (std::size_t c = 0; c < 3; ++c) channels[3 * q + c][i] = quotient[static_cast<Eigen::Index>(c)];
      }
    }
  };
  return test_means(trial, quotients(settings.real, largest), draws);
}

}  // namespace fairlight

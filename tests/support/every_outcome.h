#pragma once

#include <cstdint>
#include <map>
#include <stdexcept>
#include <vector>

namespace fairlight::testing {

/// Pixels with independent draws: pixel i draws spike[i] with probability p[i], and else 0.
struct SpikyPixels {
  std::vector<double> p;
  std::vector<double> spike;
  double mean(std::size_t pixel) const { return p[pixel] * spike[pixel]; }
};

/// Converts `draw(pixel, sample)`, which gives one sample, to the draws that an allocation takes.
template <class Draw>
auto one_by_one(Draw draw) {
  return [draw](std::size_t pixel, std::uint64_t first, std::uint64_t n) {
    std::vector<double> samples;
    for (std::uint64_t i = 0; i < n; ++i) samples.push_back(draw(pixel, first + i));
    return samples;
  };
}

/// The exact mean of every pixel of `form.estimate(draw)`, without randomness: the sum over all
/// outcomes of the first `samples` draws of each pixel, times their probability. Throws
/// std::logic_error if the form asks for more draws.
template <class Form>
std::vector<double> mean_over_every_outcome(const SpikyPixels& pixels, std::uint64_t samples, const Form& form) {
  const std::uint64_t bits = pixels.p.size() * samples;
  std::vector<double> mean(pixels.p.size(), 0.0);
  for (std::uint64_t outcome = 0; outcome < std::uint64_t{1} << bits; ++outcome) {
    const auto hits = [&](std::size_t pixel, std::uint64_t place) {
      return (outcome >> (pixel * samples + place) & 1) != 0;
    };
    std::vector<std::map<std::uint64_t, std::uint64_t>> asked(pixels.p.size());  // sample number -> its position
    const auto draw = [&](std::size_t pixel, std::uint64_t sample) {
      const std::uint64_t place = asked[pixel].try_emplace(sample, asked[pixel].size()).first->second;
      if (place >= samples) throw std::logic_error("a draw beyond those that are enumerated");
      return hits(pixel, place) ? pixels.spike[pixel] : 0;
    };
    double probability = 1;
    for (std::size_t pixel = 0; pixel < pixels.p.size(); ++pixel) {
      for (std::uint64_t place = 0; place < samples; ++place) {
        probability *= hits(pixel, place) ? pixels.p[pixel] : 1 - pixels.p[pixel];
      }
    }
    const std::vector<double> image = form.estimate(one_by_one(draw));
    for (std::size_t pixel = 0; pixel < mean.size(); ++pixel) mean[pixel] += probability * image[pixel];
  }
  return mean;
}

/// Counts the draws that a form asks for, and whether it asks for one twice.
class CountedDraws {
 public:
  explicit CountedDraws(std::size_t pixels) : seen_(pixels) {}

  auto draw() {
    return one_by_one([this](std::size_t pixel, std::uint64_t sample) {
      auto& seen = seen_.at(pixel);
      if (sample >= seen.size()) seen.resize(sample + 1, false);
      repeated_ = repeated_ || seen[sample];
      seen[sample] = true;
      ++total_;
      return static_cast<double>((7 * pixel + 3 * sample) % 11);  // an arbitrary value that varies
    });
  }
  std::uint64_t total() const { return total_; }
  bool repeated() const { return repeated_; }

 private:
  std::vector<std::vector<bool>> seen_;
  std::uint64_t total_ = 0;
  bool repeated_ = false;
};

}  // namespace fairlight::testing

#pragma once

#include <fairlight/estimators/pixel_draws.h>
#include <fairlight/validation/experiment.h>

namespace fairlight {

/// Where whole images take their numbers from: `draws(key, pixels, r)` is what image r draws with, from streams or sets
/// of its own. It also says how the rows of such images differ from those of the others.

/// The first of the units or replicates of image r, so many each. Throws std::length_error where 32 bits do not hold it.
inline std::uint32_t first_number(std::uint64_t r, std::uint64_t each) {
  if ((r + 1) * each >> 32 != 0) throw std::length_error("images have run out (2^32 numbers are of one key)");
  return static_cast<std::uint32_t>(r * each);
}

template <class Scalar = double>
struct FromStreams {
  using Real = Scalar;
  std::string suffix = real_suffix<Real>();
  std::vector<std::string> subjects{"PixelDraws"};
  double margin_factor = 1;

  template <class Pixels>
  static auto draws(const StreamKey& key, const Pixels& pixels, std::uint64_t r) {
    return PixelDraws<Real, Pixels>(key, first_number(r, pixels.grid.size()), pixels);
  }
};

/// As for every mean, the margin is twice that from independent numbers.
template <template <class> class Set>
struct FromSets {
  explicit FromSets(const PointSetKind<Set>& kind)
      : suffix("." + kind.suffix), subjects{"PixelPointSets", kind.subject} {}

  using Real = double;
  std::string suffix;
  std::vector<std::string> subjects;
  double margin_factor = 2;

  template <class Pixels>
  static auto draws(const StreamKey& key, const Pixels& pixels, std::uint64_t r) {
    constexpr std::uint32_t samples = 128;  // of a pixel, at most
    return PixelPointSets<Set<double>, Pixels>(key, first_number(r, samples * pixels.grid.size()), samples, pixels);
  }
};

/// The subjects of a row of images from such numbers.
template <class Numbers>
std::vector<std::string> with_subjects(std::vector<std::string> subjects, const Numbers& numbers) {
  subjects.insert(subjects.end(), numbers.subjects.begin(), numbers.subjects.end());
  return subjects;
}

}  // namespace fairlight

#pragma once

#include <fairlight/estimators/pixel_draws.h>
#include <fairlight/validation/checks/estimand.h>

namespace fairlight {

/// The random numbers of whole images, from streams or point sets: `draws(key, pixels, r)` gives
/// the draws of image r. It also states how the rows of such images differ from others.

/// The place of the numbers of image r. Each image has `each` units or replicates, at most 2^32. A
/// key has 2^32 of them, enough for some images; further images use the next keys. Throws
/// NoMoreDraws beyond the last key.
struct ImagePlace {
  ImagePlace(const StreamKey& purpose, std::uint64_t r, std::uint64_t each)
      : ImagePlace(purpose, r, each, (std::uint64_t{1} << 32) / each) {}

  StreamKey key;
  std::uint32_t first;

 private:
  ImagePlace(const StreamKey& purpose, std::uint64_t r, std::uint64_t each, std::uint64_t images_of_key)
      : key(purpose.further(number_in_key(r / images_of_key, "keys"))),
        first(static_cast<std::uint32_t>(r % images_of_key * each)) {}
};

template <class Scalar = double>
struct FromStreams {
  using Real = Scalar;
  std::string suffix = real_suffix<Real>();
  std::vector<std::string> subjects{"PixelDraws"};
  double margin_factor = 1;

  template <class Pixels>
  static auto draws(const StreamKey& key, const Pixels& pixels, std::uint64_t r) {
    const ImagePlace place(key, r, pixels.grid.size());
    return PixelDraws<Real, Pixels>(place.key, place.first, pixels);
  }
};

/// Numbers from point sets. As for every mean, the margin is twice that from independent numbers.
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
    constexpr std::uint32_t samples = 128;  // the most samples of a pixel
    const ImagePlace place(key, r, samples * pixels.grid.size());
    return PixelPointSets<Set<double>, Pixels>(place.key, place.first, samples, pixels);
  }
};

/// The subjects of a row of images from these numbers.
template <class Numbers>
std::vector<std::string> with_subjects(std::vector<std::string> subjects, const Numbers& numbers) {
  subjects.insert(subjects.end(), numbers.subjects.begin(), numbers.subjects.end());
  return subjects;
}

}  // namespace fairlight

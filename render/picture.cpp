#include <array>
#include <stdexcept>

#include <fairlight/render/picture.h>
#include <fairlight/stats/hash.h>

namespace fairlight {
namespace {

// Writes a word as little-endian bytes, on every machine.
void put(char*& to, std::uint64_t word) {
  for (int shift = 0; shift < 64; shift += 8) *to++ = static_cast<char>(word >> shift);
}

std::uint64_t hash_of_sums(const Film::Pixel& pixel, std::uint64_t hash) {
  std::array<char, 3 * ExactMoments::word_count * sizeof(std::uint64_t)> bytes;
  char* to = bytes.data();
  for (const ExactMoments& channel : pixel) {
    for (const std::uint64_t word : channel.words()) put(to, word);
  }
  return hash_of({bytes.data(), bytes.size()}, hash);
}

}  // namespace

std::uint64_t Picture::checksum() const {
  const nlohmann::json head{film.width(), film.height(), settings, samples.json()};
  std::uint64_t hash = hash_of(head.dump());
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) hash = hash_of_sums(film.at(x, y), hash);
  }
  return hash;
}

void Picture::merge(const Picture& other) {
  const nlohmann::json mine = settings;
  const nlohmann::json theirs = other.settings;
  for (const auto& [key, value] : mine.items()) {
    if (theirs.at(key) != value) {
      throw std::invalid_argument("renders with different settings cannot be merged (" + key + " is " +
                                  value.dump() + " in one, " + theirs.at(key).dump() + " in the other)");
    }
  }
  samples.merge(other.samples);
  film.merge(other.film);
}

}  // namespace fairlight

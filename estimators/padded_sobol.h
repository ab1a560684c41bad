#pragma once

#include <fairlight/estimators/sobol.h>
#include <fairlight/estimators/vertex_source.h>

namespace fairlight {

/// Sobol's second dimension, of a point whose first one is `reversed` in reverse order, which is the point's number; in reverse
/// order too. Pascal's triangle modulo 2, a doubling at a time.
/// Source: Ahmed 2024, "An implementation algorithm of 2D Sobol sequence fast, elegant, and compact".
template <class W>
W second_sobol_reversed(W x) {
  x ^= x >> 16;
  x ^= (x & W(0xFF00FF00u)) >> 8;
  x ^= (x & W(0xF0F0F0F0u)) >> 4;
  x ^= (x & W(0xCCCCCCCCu)) >> 2;
  return x ^ ((x & W(0xAAAAAAAAu)) >> 1);
}

/// The numbers of vertices by Sobol's first two dimensions, padded: every pair of every vertex is those two, Owen-scrambled by
/// seeds of its own, and the points of a set come in an order of its own; a single number is the first of them. So a pair is a
/// net, and what pairs have in common is chance. A table is not needed, so that lanes may be at different places.
/// Formula  u_d = scramble_d(sobol_d(order(i))), d = 0 and 1, with seeds for every (pixel, set, vertex, pair)
/// Measure  the unit cube
/// Domain   sets of n = 2^m <= 1024 points (throws std::invalid_argument otherwise)
/// Random   eight words for five numbers of a set's points; in double more for the digits after the 32nd
/// Source   Burley 2020, "Practical hash-based Owen scrambling"; PBR 4ed, 8.6.5 (PaddedSobolSampler)
class PaddedSobol {
 public:
  PaddedSobol(const StreamKey& key, std::uint32_t n) : key_(key), sets_(n) {}

  const SetsOfPoints& sets() const { return sets_; }

  template <class Real>
  Five<Real> block(const PathVertex<Real>& at, std::uint32_t b) const {
    using W = Word<Real>;
    const auto first = sets_.shared_words(key_, at, b, 0);
    const auto second = sets_.shared_words(key_, at, b, 1);
    const W point = sets_.point_of(at.sample);
    Five<Digits<W>> digits{};  // whose upper words go below those of Sobol's
    if constexpr (lanes<Real> == 1) digits = independent_digits(key_, at, b);
    for (std::size_t pair = 0; pair < 2; ++pair) {
      const auto& seeds = pair == 0 ? first : second;
      const W turned = (seeds[2] << 16) | (seeds[2] >> 16);
      const W order = shuffled(point, sets_.bits(), seeds[2]);
      scramble(digits[2 * pair], order, seeds[0], seeds[2]);
      scramble(digits[2 * pair + 1], second_sobol_reversed(order), seeds[1], turned);
    }
    scramble(digits[4], shuffled(point, sets_.bits(), second[3]), first[3], second[3]);
    return unit_numbers<Real>(digits);
  }

 private:
  // The shift is independent of the order and of the factor, and makes the number uniform, exactly.
  template <class W>
  static void scramble(Digits<W>& digits, const W& reversed, const W& shift, const W& factor) {
    digits = {reverse_bits(scramble_upwards(reversed, shift, factor)), digits.high};
  }

  StreamKey key_;
  SetsOfPoints sets_;
};

}  // namespace fairlight

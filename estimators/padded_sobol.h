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
/// Random   four words for five numbers of a set's points, and a hash for orders and factors; in double more for the digits after
///          the 24th
/// Source   Burley 2020, "Practical hash-based Owen scrambling"; PBR 4ed, 8.6.5 (PaddedSobolSampler)
class PaddedSobol {
 public:
  PaddedSobol(const StreamKey& key, std::uint32_t n) : key_(key), sets_(n) {}

  const SetsOfPoints& sets() const { return sets_; }

  template <class Real>
  Five<Real> block(const PathVertex<Real>& at, std::uint32_t b) const {
    using W = Word<Real>;
    const Five<W> shifts = five_of(sets_.shared_words(key_, at, b));
    const std::array<W, 3> words = sets_.order_words(key_, at, b);
    const W point = sets_.point_of(at.sample);
    Five<Digits<W>> digits{};
    if constexpr (lanes<Real> == 1) digits = independent_digits(key_, at, b);
    // The halves of a word are the lower halves of two factors, and only those are felt by digits that come soon after points part.
    for (std::size_t pair = 0; pair < 2; ++pair) {
      const W& word = words[pair];
      const W order = shuffled(point, sets_.bits(), word);
      lead(digits[2 * pair], order, shifts[2 * pair], word);
      lead(digits[2 * pair + 1], second_sobol_reversed(order), shifts[2 * pair + 1],
           W((word << 16) | (word >> 16)));
    }
    lead(digits[4], shuffled(point, sets_.bits(), words[2]), shifts[4], words[2]);
    return unit_numbers<Real>(digits);
  }

 private:
  // Puts the first 24 digits before those that are there. The shift is independent of the order and of the factor, and makes the
  // number uniform, exactly.
  template <class W>
  static void lead(Digits<W>& digits, const W& reversed, const W& shift, const W& factor) {
    const W first = reverse_bits(scramble_upwards(reversed, W(shift >> 8), factor));
    digits = {(first & W(0xFFFFFF00u)) | (digits.high >> 24), digits.low};
  }

  StreamKey key_;
  SetsOfPoints sets_;
};

}  // namespace fairlight

#pragma once

#include <utility>

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

  const SampleSets& sets() const { return sets_; }

  template <class Real>
  SampleBlock<Real> block(const PathVertex<Real>& at, std::uint32_t b, BlockPart part = BlockPart::all) const {
    return part == BlockPart::all ? first<5>(at, b) : first<2>(at, b);
  }

 private:
  // The first n of a block, of which the compiler leaves out what is not asked for. The orders, which take the longest, come first, so that
  // a machine works on the random words meanwhile.
  template <std::size_t n, class Real>
  SampleBlock<Real> first(const PathVertex<Real>& at, std::uint32_t b) const {
    using W = Word<Real>;
    const W point = sets_.point_of(at.sample);
    const std::array<W, 3> words = sets_.order_words(key_, at, b);
    const auto order = [&](std::size_t i) { return shuffled(point, sets_.bits(), words[i]); };
    const std::array<W, 3> orders{order(0), order(1), order(2)};
    const SampleBlock<W> reversed{orders[0], second_sobol_reversed(orders[0]), orders[1],
                                  second_sobol_reversed(orders[1]), orders[2]};
    // The halves of a word are the lower halves of two factors, and only those are felt by digits that come soon after points part.
    const auto swapped = [](const W& word) { return W((word << 16) | (word >> 16)); };
    const SampleBlock<W> factors{words[0], swapped(words[0]), words[1], swapped(words[1]), words[2]};
    const SampleBlock<W> shifts = five_of(sets_.shared_words(key_, at, b));
    const auto following = following_digits(at, b);
    SampleBlock<Real> numbers{};
    const auto make = [&](std::size_t i) {
      numbers[i] = scrambled<Real>(reversed[i], shifts[i], factors[i], following[i]);
    };
    [&]<std::size_t... i>(std::index_sequence<i...>) { (make(i), ...); }
    (std::make_index_sequence<n>());
    return numbers;
  }

  // A number of 24 scrambled digits, after which come in double those of `following`. The shift is independent of the order and of the
  // factor, and makes the 24 uniform, exactly.
  template <class Real, class W>
  static Real scrambled(const W& reversed, const W& shift, const W& factor, const Fixed64<W>& following) {
    const W digits = reverse_bits(scramble_upwards(reversed, W(shift >> 8), factor));
    if constexpr (lanes<Real> == 1)
      return unit_number((digits & W(0xFFFFFF00u)) | (following.high >> 24), following.low);
    return unit_number(digits, W(0u));
  }

  template <class Real>
  SampleBlock<Fixed64<Word<Real>>> following_digits(const PathVertex<Real>& at, std::uint32_t b) const {
    if constexpr (lanes<Real> == 1) return independent_digits(key_, at, b);
    return {};
  }

  StreamKey key_;
  SampleSets sets_;
};

}  // namespace fairlight

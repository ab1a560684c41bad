#pragma once

#include <utility>

#include <fairlight/estimators/sobol.h>
#include <fairlight/estimators/vertex_source.h>

namespace fairlight {

/// Sobol's second dimension, in reverse bit order. x is the first dimension in reverse bit order,
/// which is the point's number. Multiplies by Pascal's triangle modulo 2, doubling its size in each
/// step.
/// Source   Ahmed 2024, "An implementation algorithm of 2D Sobol sequence fast, elegant, and
///          compact"
template <class W>
W second_sobol_reversed(W x) {
  x ^= x >> 16;
  x ^= (x & W(0xFF00FF00u)) >> 8;
  x ^= (x & W(0xF0F0F0F0u)) >> 4;
  x ^= (x & W(0xCCCCCCCCu)) >> 2;
  return x ^ ((x & W(0xAAAAAAAAu)) >> 1);
}

/// Padded Sobol sampling of path vertices: Owen-scrambled pairs of Sobol's first two dimensions.
/// Formula  u_d = scramble_d(sobol_d(order(i))), d = 0, 1; seeds for every (pixel, set, vertex,
///          pair)
/// Measure  the unit cube
/// Domain   sets of n = 2^m <= 1024 points (throws std::invalid_argument otherwise)
/// Random   four words for five numbers of a set, a hash for orders and factors; in double, more
///          words for the digits after the 24th
/// Source   Burley 2020, "Practical hash-based Owen scrambling"; PBR 4ed, 8.6.5
class PaddedSobol {
  // Each pair of each vertex has its own scrambling seeds and its own order of the set's points. So
  // every pair is a (0,2)-net, and different pairs are related by chance only. A single number is
  // the first of the two dimensions. No table is needed, so lanes may be at different vertices.
 public:
  PaddedSobol(const StreamKey& key, std::uint32_t n) : key_(key), sets_(n) {}

  const SampleSets& sets() const { return sets_; }

  template <class Real>
  SampleBlock<Real> block(const PathVertex<Real>& at, std::uint32_t b, BlockPart part = BlockPart::all) const {
    return part == BlockPart::all ? first<5>(at, b) : first<2>(at, b);
  }

 private:
  // The first n numbers of a block; the compiler leaves out the rest. The orders take longest and
  // come first, so that the processor computes the random words meanwhile.
  template <std::size_t n, class Real>
  SampleBlock<Real> first(const PathVertex<Real>& at, std::uint32_t b) const {
    using W = Word<Real>;
    const W point = sets_.point_of(at.sample);
    const std::array<W, 3> words = sets_.order_words(key_, at, b);
    const auto order = [&](std::size_t i) { return shuffled(point, sets_.bits(), words[i]); };
    const std::array<W, 3> orders{order(0), order(1), order(2)};
    const SampleBlock<W> reversed{orders[0], second_sobol_reversed(orders[0]), orders[1],
                                  second_sobol_reversed(orders[1]), orders[2]};
    // Each order word makes two factors: the word, and the word with its halves swapped. The digits
    // that follow soon after two points part depend on the lower half of the factor only.
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

  // 24 scrambled digits; in double, those of `following` come after them. The shift is independent
  // of the order and of the factor, which makes the 24 digits exactly uniform.
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

#pragma once

#include <bit>
#include <string>

#include <fairlight/estimators/point_set.h>

namespace fairlight {

/// The vertex whose numbers are drawn. Each lane holds one path, and lanes may differ in pixel,
/// sample and vertex.
template <class Real>
struct PathVertex {
  Word<Real> pixel, sample, vertex;
};

/// Numbers of a vertex come in blocks of five: two pairs, each stratified as a pair (if at all),
/// and a single one. That is what a shadow ray, a roulette and a bounce need, and what a Philox
/// block holds in packets. `first_pair` computes only the first pair, for vertices that need no
/// more; the other numbers are then invalid.
enum class BlockPart { all, first_pair };

/// 64 binary digits of a number in [0,1); packets use the first 24.
template <class W>
struct Fixed64 {
  W high, low;
};

/// Four random words of a vertex, for a sample or a set of samples of the pixel.
template <class Real>
std::array<Word<Real>, 4> vertex_words(const StreamKey& key, std::uint32_t i, const Word<Real>& sample,
                                       const PathVertex<Real>& at) {
  using W = Word<Real>;
  return Philox<W>::draw({W(i), sample, at.vertex, at.pixel}, {W(key.words()[0]), W(key.words()[1])});
}

/// Five independent numbers of block b, in packets with 24 digits each. Shared words of sets use
/// counters from 2^31 on.
template <class Real>
SampleBlock<Fixed64<Word<Real>>> independent_digits(const StreamKey& key, const PathVertex<Real>& at,
                                                    std::uint32_t b) {
  using W = Word<Real>;
  const auto first = vertex_words(key, 4 * b, at.sample, at);
  if constexpr (lanes<Real> == 1) {
    const auto second = vertex_words(key, 4 * b + 1, at.sample, at);
    const auto third = vertex_words(key, 4 * b + 2, at.sample, at);
    return {{{first[0], first[1]},
             {first[2], first[3]},
             {second[0], second[1]},
             {second[2], second[3]},
             {third[0], third[1]}}};
  } else {
    const SampleBlock<W> numbers = five_of(first);
    const W none(0u);
    return {{{numbers[0], none}, {numbers[1], none}, {numbers[2], none}, {numbers[3], none}, {numbers[4], none}}};
  }
}

/// Converts digits to numbers in [0,1).
template <class Real>
SampleBlock<Real> unit_numbers(const SampleBlock<Fixed64<Word<Real>>>& digits) {
  SampleBlock<Real> numbers;
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = unit_number(digits[i].high, digits[i].low);
  return numbers;
}

/// Independent numbers for all vertices.
/// Source   Salmon et al. 2011
class IndependentNumbers {
 public:
  explicit IndependentNumbers(const StreamKey& key, std::uint32_t /*points of a set*/ = 1) : key_(key) {}

  template <class Real>
  SampleBlock<Real> block(const PathVertex<Real>& at, std::uint32_t b, BlockPart /*part*/ = BlockPart::all) const {
    return unit_numbers<Real>(independent_digits(key_, at, b));
  }

 private:
  StreamKey key_;
};

/// A hash of a word.
/// Source   Wellons 2018, "Prospecting for hash functions" (lowbias32)
template <class W>
W mixed_bits(W x) {
  x ^= x >> 16;
  x *= W(0x7FEB352Du);
  x ^= x >> 15;
  x *= W(0x846CA68Bu);
  return x ^ (x >> 16);
}

/// Groups a pixel's samples into sets of n = 2^m points that are stratified together: samples 0 ..
/// n-1, n .. 2n-1 and so on. The shared words of different sets, pixels, vertices and blocks are
/// independent.
class SampleSets {
 public:
  /// Throws std::invalid_argument unless n is a power of two from 1 to 1024.
  explicit SampleSets(std::uint32_t n) : bits_(static_cast<std::uint32_t>(std::bit_width(n)) - 1) {
    if (!std::has_single_bit(n) || n > 1024)
      throw std::invalid_argument("a set of " + std::to_string(n) +
                                  " points (give a power of two, from 1 to 1024)");
  }

  std::uint32_t bits() const { return bits_; }
  std::uint32_t size() const { return 1u << bits_; }

  template <class W>
  W set_of(const W& sample) const {
    return sample >> static_cast<int>(bits_);
  }
  template <class W>
  W point_of(const W& sample) const {
    return sample & W(size() - 1);
  }

  /// Four random words of block b that the points of a set share.
  template <class Real>
  std::array<Word<Real>, 4> shared_words(const StreamKey& key, const PathVertex<Real>& at, std::uint32_t b) const {
    constexpr std::uint32_t shared = 0x80000000u;
    return vertex_words(key, shared | b, set_of(at.sample), at);
  }

  /// Three more words, for the orders of the points. No mean depends on them, so a hash is enough;
  /// it is faster.
  /// Source   Collet 2012, xxHash (the odd factors)
  template <class Real>
  std::array<Word<Real>, 3> order_words(const StreamKey& key, const PathVertex<Real>& at, std::uint32_t b) const {
    using W = Word<Real>;
    constexpr std::uint32_t odd[]{0x9E3779B1u, 0x85EBCA77u, 0xC2B2AE3Du, 0x27D4EB2Fu};
    const W place = at.pixel * W(odd[0]) + set_of(at.sample) * W(odd[1]) + at.vertex * W(odd[2]);
    const W hash = mixed_bits(W(place + W(key.words()[0] + odd[3] * b))) ^ W(key.words()[1]);
    const auto word = [&hash](std::uint32_t factor) {
      const W product = hash * W(factor);
      return W(product ^ (product >> 16));
    };
    return {word(odd[0]), word(odd[1]), word(odd[2])};
  }

 private:
  std::uint32_t bits_;
};

/// The place of point i < 2^bits <= 1024 in an order given by a random word: four rounds of an
/// affine map and a shift, each one to one. The joint variation of two dimensions that are padded
/// by it is within 5 % of that under random permutations.
template <class W>
W shuffled(const W& i, std::uint32_t bits, const W& word) {
  const W mask((1u << bits) - 1);
  const int half = static_cast<int>((bits + 1) / 2);
  W x = i;
  for (int round = 0; round < 4; ++round) {
    x = (multiply_halves(x, W((word >> (5 * round)) | W(1u))) + (word >> (7 * round + 3))) & mask;
    x ^= x >> half;
  }
  return x;
}

/// A UniformSource: the numbers of one path vertex, one path per lane. A number is a function of
/// (key, pixel, sample, vertex, dimension) and, after the first pair, of the part. It does not
/// depend on the lane.
/// Source   Salmon et al. 2011; Pharr, Jakob, Humphreys, PBR 4ed, 8.3 (pairs and single numbers are
///          separate requests)
template <class Real, class Numbers>
class VertexSource {
  // `numbers.block(at, b, part)` gives five numbers, or only the first pair. With `first_pair`, a
  // vertex that needs more numbers than that takes the first pairs of further blocks.
 public:
  VertexSource(const Numbers& numbers, const PathVertex<Real>& at, BlockPart part = BlockPart::all)
      : numbers_(numbers), at_(at), part_(part) {}

  /// The next two dimensions.
  std::array<Real, 2> pair() {
    if (pairs_left_ == 0) {
      block_ = numbers_.template block<Real>(at_, blocks_++, part_);
      if (part_ == BlockPart::first_pair) return {block_[0], block_[1]};
      pairs_left_ = 2;
      singles_[0] = block_[4];
      singles_left_ = 1;
    }
    const std::size_t i = 4 - 2 * pairs_left_--;
    return {block_[i], block_[i + 1]};
  }

  /// The next dimension: a single number left over from a block, or the first of a new pair, whose
  /// second is kept for later.
  Real next() {
    if (singles_left_ != 0) return singles_[--singles_left_];
    const std::array<Real, 2> two = pair();
    singles_[singles_left_++] = two[1];
    return two[0];
  }

 private:
  const Numbers& numbers_;
  PathVertex<Real> at_;
  BlockPart part_;
  SampleBlock<Real> block_{};
  std::array<Real, 2> singles_{};
  std::uint32_t blocks_ = 0;
  std::size_t pairs_left_ = 0, singles_left_ = 0;
};

}  // namespace fairlight

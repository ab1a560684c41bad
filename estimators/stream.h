#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include <fairlight/estimators/packet_words.h>
#include <fairlight/stats/hash.h>

namespace fairlight {

/// Philox 4x32-10: a counter and a key to four uniform 32-bit words, without state. Word may be a packet of words.
/// Source: Salmon et al. 2011, "Parallel random numbers: as easy as 1, 2, 3"; known answers in the tests.
template <class Word>
struct Philox {
  using Counter = std::array<Word, 4>;
  using Key = std::array<Word, 2>;

  static Counter draw(Counter counter, Key key) {
    for (int round = 0; round < 10; ++round) {
      const auto [high0, low0] = multiply_high_low(0xD2511F53u, counter[0]);
      const auto [high1, low1] = multiply_high_low(0xCD9E8D57u, counter[2]);
      counter = {high1 ^ counter[1] ^ key[0], low1, high0 ^ counter[3] ^ key[1], low0};
      key = {key[0] + Word(0x9E3779B9u), key[1] + Word(0xBB67AE85u)};
    }
    return counter;
  }
};

/// The number in [0,1) whose binary digits are the words': 53 of them, or 24 in packets.
inline double unit_number(std::uint32_t high, std::uint32_t low) {
  return static_cast<double>((std::uint64_t{high} << 21) | (low >> 11)) * 0x1p-53;
}
template <class A>
xsimd::batch<float, A> unit_number(const xsimd::batch<std::uint32_t, A>& high,
                                   const xsimd::batch<std::uint32_t, A>& /*low*/) {
  return xsimd::to_float(xsimd::bitwise_cast<xsimd::batch<std::int32_t, A>>(high >> 8)) * 0x1p-24f;
}

/// That of 27 digits of the first word and 26 of the second.
inline double unit_number_of_halves(std::uint32_t high, std::uint32_t low) {
  return static_cast<double>((std::uint64_t{high >> 5} << 26) | (low >> 6)) * 0x1p-53;
}

/// Five of something, as many as a block of random words has numbers of 24 digits.
template <class Number>
using SampleBlock = std::array<Number, 5>;

/// Five numbers of 24 digits each, at the top of their words: four words' own, and the lower 8 of three.
template <class W>
SampleBlock<W> five_of(const std::array<W, 4>& words) {
  const W low(0xFFu);
  const W last = ((words[0] & low) << 24) | ((words[1] & low) << 16) | ((words[2] & low) << 8);
  return {words[0], words[1], words[2], words[3], last};
}

/// What draws are for: a seed and a purpose (the name of a claim, or of a render), folded into one key, so that no
/// two purposes share numbers. The fold is FNV-1a, then one Philox block under the seed.
class StreamKey {
 public:
  StreamKey(std::uint64_t seed, std::string_view purpose) {
    const std::uint64_t hash = hash_of(purpose);
    const auto block = Philox<std::uint32_t>::draw({low(hash), high(hash), 0, 0}, {low(seed), high(seed)});
    key_ = {block[0], block[1]};
  }
  const Philox<std::uint32_t>::Key& words() const { return key_; }

  /// Key n of those that a purpose may use one after the other, where the numbers of one run out; key 0 is this one.
  /// All 2^32 differ.
  StreamKey further(std::uint32_t n) const {
    StreamKey key = *this;
    key.key_[0] += n;
    return key;
  }

 private:
  static std::uint32_t low(std::uint64_t x) { return static_cast<std::uint32_t>(x); }
  static std::uint32_t high(std::uint64_t x) { return static_cast<std::uint32_t>(x >> 32); }
  Philox<std::uint32_t>::Key key_;
};

/// A UniformSource: the numbers of one sample, in [0,1), one dimension after the other. A number is
/// a function of (key, unit, sample, dimension) and of nothing else; a unit is a pixel, a chain or
/// a block of draws. Source: Salmon et al. 2011, whose function is Philox.
template <class Real>
class PhiloxStream;

template <>
class PhiloxStream<double> {
 public:
  PhiloxStream(const StreamKey& key, std::uint32_t unit, std::uint64_t sample)
      : key_(key.words()),
        counter_{0, static_cast<std::uint32_t>(sample), static_cast<std::uint32_t>(sample >> 32), unit} {}

  /// The next dimension, a multiple of 2^-53 in [0,1).
  double next() {
    if (left_ == 0) {
      block_ = Philox<std::uint32_t>::draw(counter_, key_);
      ++counter_[0];
      left_ = 2;
    }
    --left_;
    return unit_number_of_halves(block_[2 * left_], block_[2 * left_ + 1]);
  }

 private:
  Philox<std::uint32_t>::Key key_;
  Philox<std::uint32_t>::Counter counter_;
  Philox<std::uint32_t>::Counter block_{};
  std::size_t left_ = 0;
};

/// The same for packets: a lane is a sample, and a number a multiple of 2^-24, so a block of 128 bits holds five. What a lane
/// gets does not depend on how many lanes there are.
template <class A>
class PhiloxStream<xsimd::batch<float, A>> {
 public:
  using Real = xsimd::batch<float, A>;
  using Word = xsimd::batch<std::uint32_t, A>;

  /// Of the samples `first`, `first` + 1, ..., one a lane.
  PhiloxStream(const StreamKey& key, std::uint32_t unit, std::uint64_t first)
      : key_{Word(key.words()[0]), Word(key.words()[1])},
        counter_{Word(0u), Word(static_cast<std::uint32_t>(first)) + lane_numbers<A>(),
                 Word(static_cast<std::uint32_t>(first >> 32)), Word(unit)} {
    counter_[2] += select(counter_[1] < lane_numbers<A>(), Word(1u), Word(0u));  // where the low word has wrapped
  }

  /// The next dimension.
  Real next() {
    if (used_ == five_.size()) {
      five_ = five_of(Philox<Word>::draw(counter_, key_));
      counter_[0] += Word(1u);
      used_ = 0;
    }
    return unit_number(five_[used_++], Word(0u));
  }

 private:
  typename Philox<Word>::Key key_;
  typename Philox<Word>::Counter counter_;
  SampleBlock<Word> five_{};
  std::size_t used_ = five_.size();
};

}  // namespace fairlight

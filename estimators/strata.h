#pragma once

#include <bit>

#include <fairlight/estimators/point_set.h>

namespace fairlight {

/// Kensler's hash: a permutation of the low b bits, mask = 2^b - 1.
/// Source   Kensler 2013, "Correlated multi-jittered sampling", listing 3
template <class W>
W permute_bits(W i, std::uint32_t mask, std::uint32_t seed) {
  const W low(mask);
  i ^= W(seed);
  i *= W(0xE170893Du);
  i ^= W(seed >> 16);
  i ^= (i & low) >> 4;
  i ^= W(seed >> 8);
  i *= W(0x0929EB3Fu);
  i ^= W(seed >> 23);
  i ^= (i & low) >> 1;
  i *= W(1u | seed >> 27);
  i *= W(0x6935FA69u);
  i ^= (i & low) >> 11;
  i *= W(0x74DCB303u);
  i ^= (i & low) >> 2;
  i *= W(0x9E501CC3u);
  i ^= (i & low) >> 2;
  i *= W(0xC860A3DFu);
  i &= low;
  return i ^ (i >> 5);
}

/// The image of i < n under a permutation of 0 .. n-1. Repeats the hash until the result is below
/// n, and then rotates. The rotation alone makes every image equally likely (to n 2^-32), whatever
/// the hash does.
template <class W>
W permute(W i, std::uint32_t n, std::uint32_t seed, std::uint32_t rotation) {
  const std::uint32_t mask = std::bit_ceil(n) - 1;
  i = permute_bits(i, mask, seed);
  while (any(i >= W(n))) i = select(i >= W(n), permute_bits(i, mask, seed), i);
  const W turned = i + W(multiply_high_low(rotation, n)[0]);
  return select(turned >= W(n), W(turned - W(n)), turned);
}

/// The quotient and the remainder.
inline std::array<std::uint32_t, 2> divide(std::uint32_t x, std::uint32_t by) { return {x / by, x % by}; }
template <class A>
std::array<xsimd::batch<std::uint32_t, A>, 2> divide(const xsimd::batch<std::uint32_t, A>& x, std::uint32_t by) {
  using W = xsimd::batch<std::uint32_t, A>;
  std::array<std::uint32_t, W::size> words{};
  x.store_unaligned(words.data());
  for (std::uint32_t& word : words) word /= by;
  const W quotient = W::load_unaligned(words.data());
  return {quotient, W(x - quotient * W(by))};
}

/// A number in [0,1), uniform in the stratum [stratum/n, (stratum+1)/n). With J the jitter's 53
/// digits, it is 2^-53 times the integer part of (stratum 2^53 + J) / n, by long division. So it
/// never reaches 1. If all strata are equally likely, it is exactly uniform.
inline double in_stratum(std::uint32_t stratum, std::uint32_t n, std::uint32_t high, std::uint32_t low) {
  const std::uint64_t first = (std::uint64_t{stratum} << 32) | high;
  const std::uint64_t rest = ((first % n) << 21) | (low >> 11);
  return static_cast<double>(((first / n) << 21) | (rest / n)) * 0x1p-53;
}

/// The same in packets, with 24 digits.
template <class A>
xsimd::batch<float, A> in_stratum(const xsimd::batch<std::uint32_t, A>& stratum, std::uint32_t n,
                                  const xsimd::batch<std::uint32_t, A>& high,
                                  const xsimd::batch<std::uint32_t, A>& /*low*/) {
  constexpr std::size_t size = xsimd::batch<float, A>::size;
  std::array<std::uint32_t, size> strata{};
  std::array<std::uint32_t, size> jitter{};
  std::array<float, size> numbers{};
  stratum.store_unaligned(strata.data());
  high.store_unaligned(jitter.data());
  for (std::size_t i = 0; i < size; ++i) {
    numbers[i] = static_cast<float>(((std::uint64_t{strata[i]} << 24) | (jitter[i] >> 8)) / n) * 0x1p-24f;
  }
  return xsimd::batch<float, A>::load_unaligned(numbers.data());
}

}  // namespace fairlight

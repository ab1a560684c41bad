#pragma once

#include <array>
#include <cstdint>

#include <fairlight/estimators/packet.h>

/// Operations on packets of words that random numbers need and xsimd lacks.

namespace fairlight {

namespace detail {

/// Widening multiplication. `even_products` gives the 64-bit products of the even 32-bit words.
/// `upper_halves` and `lower_halves` interleave the halves of the even and odd products, in the
/// order of the words.
#if defined(__AVX512F__)
inline __m512i even_products(__m512i a, __m512i b) { return _mm512_mul_epu32(a, b); }
inline __m512i upper_halves(__m512i even, __m512i odd) {
  return _mm512_mask_shuffle_epi32(odd, 0x5555, even, _MM_PERM_DDBB);
}
inline __m512i lower_halves(__m512i even, __m512i odd) {
  return _mm512_mask_shuffle_epi32(even, 0xAAAA, odd, _MM_PERM_CCAA);
}
#endif
#if defined(__AVX2__)
inline __m256i even_products(__m256i a, __m256i b) { return _mm256_mul_epu32(a, b); }
inline __m256i upper_halves(__m256i even, __m256i odd) {
  return _mm256_blend_epi32(_mm256_srli_epi64(even, 32), odd, 0xAA);
}
inline __m256i lower_halves(__m256i even, __m256i odd) {
  return _mm256_blend_epi32(even, _mm256_slli_epi64(odd, 32), 0xAA);
}
#endif
#if defined(__SSE2__)
inline __m128i even_products(__m128i a, __m128i b) { return _mm_mul_epu32(a, b); }
inline __m128i upper_halves(__m128i even, __m128i odd) {
  return _mm_or_si128(_mm_srli_epi64(even, 32), _mm_andnot_si128(_mm_set1_epi64x(0xFFFFFFFF), odd));
}
inline __m128i lower_halves(__m128i even, __m128i odd) {
  return _mm_or_si128(_mm_and_si128(_mm_set1_epi64x(0xFFFFFFFF), even), _mm_slli_epi64(odd, 32));
}
#elif defined(__aarch64__)
inline uint64x2_t even_products(uint64x2_t a, uint64x2_t b) { return vmull_u32(vmovn_u64(a), vmovn_u64(b)); }
inline uint64x2_t upper_halves(uint64x2_t even, uint64x2_t odd) {
  return vreinterpretq_u64_u32(vtrn2q_u32(vreinterpretq_u32_u64(even), vreinterpretq_u32_u64(odd)));
}
inline uint64x2_t lower_halves(uint64x2_t even, uint64x2_t odd) {
  return vreinterpretq_u64_u32(vtrn1q_u32(vreinterpretq_u32_u64(even), vreinterpretq_u32_u64(odd)));
}
#endif

}  // namespace detail

template <class A>
std::array<xsimd::batch<std::uint32_t, A>, 2> multiply_high_low(std::uint32_t a,
                                                                const xsimd::batch<std::uint32_t, A>& b) {
  using Word = xsimd::batch<std::uint32_t, A>;
  using Wide = xsimd::batch<std::uint64_t, A>;
  const Wide factor(std::uint64_t{a});
  const Wide words = xsimd::bitwise_cast<Wide>(b);
  const Wide even = detail::even_products(factor, words);
  const Wide odd = detail::even_products(factor, words >> 32);
  const Wide high = detail::upper_halves(even, odd);
  const Wide low = detail::lower_halves(even, odd);
  return {xsimd::bitwise_cast<Word>(high), xsimd::bitwise_cast<Word>(low)};
}

template <class A>
xsimd::batch<std::uint32_t, A> multiply_halves(const xsimd::batch<std::uint32_t, A>& a,
                                               const xsimd::batch<std::uint32_t, A>& b) {
  using Half = xsimd::batch<std::uint16_t, A>;
  return xsimd::bitwise_cast<xsimd::batch<std::uint32_t, A>>(xsimd::bitwise_cast<Half>(a) *
                                                             xsimd::bitwise_cast<Half>(b));
}

#if defined(__AVX2__)
namespace detail {

/// In each block of 16 bytes: `bytes_at` takes the bytes of x at the given places; `look_up_bytes`
/// takes the bytes of a table at the places that x holds.
#if defined(__AVX512F__)
inline __m512i bytes_at(__m128i places, __m512i x) {
  return _mm512_shuffle_epi8(x, _mm512_broadcast_i32x4(places));
}
inline __m512i look_up_bytes(__m128i table, __m512i x) {
  return _mm512_shuffle_epi8(_mm512_broadcast_i32x4(table), x);
}
#endif
inline __m256i bytes_at(__m128i places, __m256i x) {
  return _mm256_shuffle_epi8(x, _mm256_broadcastsi128_si256(places));
}
inline __m256i look_up_bytes(__m128i table, __m256i x) {
  return _mm256_shuffle_epi8(_mm256_broadcastsi128_si256(table), x);
}

}  // namespace detail

/// Reverses the bits: reverses the bytes of each word, and looks up the reverse of each half byte.
inline xsimd::batch<std::uint32_t> reverse_bits(const xsimd::batch<std::uint32_t>& x) {
  using Word = xsimd::batch<std::uint32_t>;
  const __m128i turned = _mm_setr_epi8(3, 2, 1, 0, 7, 6, 5, 4, 11, 10, 9, 8, 15, 14, 13, 12);
  const __m128i reversed = _mm_setr_epi8(0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15);
  const Word half(0x0F0F0F0Fu), bytes = detail::bytes_at(turned, x);
  const Word high = detail::look_up_bytes(_mm_slli_epi16(reversed, 4), bytes & half);
  const Word low = detail::look_up_bytes(reversed, (bytes >> 4) & half);
  return high | low;
}
#endif

}  // namespace fairlight

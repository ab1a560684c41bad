#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

#include <Eigen/Core>
#include <xsimd/xsimd.hpp>

#include <fairlight/estimators/real.h>

namespace fairlight {

/// A SIMD vector of 4, 8 or 16 floats, depending on the instruction set that the code is compiled
/// for. Source: xsimd.
using Packet = xsimd::batch<float>;

template <class A>
struct LaneOf<xsimd::batch<float, A>> {
  using Type = float;
};

template <class A>
inline constexpr std::size_t lanes<xsimd::batch<float, A>> = xsimd::batch<float, A>::size;

template <class A>
struct IndexOf<xsimd::batch<float, A>> {
  using Type = xsimd::batch<std::int32_t, A>;
};

template <class A>
struct WordOf<xsimd::batch<float, A>> {
  using Type = xsimd::batch<std::uint32_t, A>;
};

/// A vector or a colour, lane by lane.
template <class A, int Size>
Eigen::Matrix<xsimd::batch<float, A>, Size, 1> select(const xsimd::batch_bool<float, A>& mask,
                                                      const Eigen::Matrix<xsimd::batch<float, A>, Size, 1>& a,
                                                      const Eigen::Matrix<xsimd::batch<float, A>, Size, 1>& b) {
  Eigen::Matrix<xsimd::batch<float, A>, Size, 1> chosen;
  for (int i = 0; i < Size; ++i) chosen[i] = select(mask, a[i], b[i]);
  return chosen;
}
template <class A, int Size>
Eigen::Array<xsimd::batch<float, A>, Size, 1> select(const xsimd::batch_bool<float, A>& mask,
                                                     const Eigen::Array<xsimd::batch<float, A>, Size, 1>& a,
                                                     const Eigen::Array<xsimd::batch<float, A>, Size, 1>& b) {
  return select(mask, a.matrix().eval(), b.matrix().eval()).array();
}

template <class A>
xsimd::batch<std::int32_t, A> to_int(const xsimd::batch<float, A>& x) {
  return xsimd::to_int(x);
}

template <class A>
xsimd::batch<std::uint32_t, A> leading_bits(const xsimd::batch<float, A>& x) {
  return xsimd::bitwise_cast<xsimd::batch<std::uint32_t, A>>(to_int(x * 0x1p24f)) << 8;
}

template <class A>
bool all_finite(const xsimd::batch<float, A>& x) {
  using W = xsimd::batch<std::uint32_t, A>;
  const W exponent(0x7F800000u);
  return !any((xsimd::bitwise_cast<W>(x) & exponent) == exponent);
}

/// Whether every lane is in [low, high]. A NaN is not, even with -ffast-math.
template <class Real>
bool all_within(const Real& x, double low, double high) {
  return all_finite(x) && all(x >= rounded<Real>(low) && x <= rounded<Real>(high));
}

/// Whether every lane is positive and finite; nonnegative and finite.
template <class Real>
bool all_positive(const Real& x) {
  return all_finite(x) && all(x > Real(0));
}
template <class Real>
bool all_nonnegative(const Real& x) {
  return all_finite(x) && all(x >= Real(0));
}

template <class A>
xsimd::batch<std::int32_t, A> index_of(const xsimd::batch<std::uint32_t, A>& word) {
  return xsimd::bitwise_cast<xsimd::batch<std::int32_t, A>>(word);
}

template <class A>
xsimd::batch<std::uint32_t, A> word_of(const xsimd::batch<std::int32_t, A>& index) {
  return xsimd::bitwise_cast<xsimd::batch<std::uint32_t, A>>(index);
}

template <class Real, class A>
Mask<Real> same_index(const xsimd::batch<std::int32_t, A>& a, const xsimd::batch<std::int32_t, A>& b) {
  return xsimd::to_float(a) == xsimd::to_float(b);
}

/// The mask as bits; the first lane is the lowest bit.
#if defined(__AVX512F__)
inline std::uint32_t lane_bits(const xsimd::batch_bool<float>& mask) {
  return static_cast<xsimd::batch_bool<float>::register_type>(mask);
}
#elif defined(__AVX__)
inline std::uint32_t lane_bits(const xsimd::batch_bool<float>& mask) {
  return static_cast<std::uint32_t>(_mm256_movemask_ps(mask));
}
#elif defined(__SSE2__)
inline std::uint32_t lane_bits(const xsimd::batch_bool<float>& mask) {
  return static_cast<std::uint32_t>(_mm_movemask_ps(mask));
}
#else
inline std::uint32_t lane_bits(const xsimd::batch_bool<float>& mask) {
  std::array<bool, xsimd::batch<float>::size> held{};
  mask.store_unaligned(held.data());
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < held.size(); ++i) bits |= std::uint32_t{held[i]} << i;
  return bits;
}
#endif

#if defined(__AVX512F__)
inline xsimd::batch<float> expand(std::uint32_t bits, const float* next, const xsimd::batch<float>& kept) {
  return _mm512_mask_expandloadu_ps(kept, static_cast<__mmask16>(bits), next);
}
inline xsimd::batch<std::uint32_t> expand(std::uint32_t bits, const std::uint32_t* next,
                                          const xsimd::batch<std::uint32_t>& kept) {
  return _mm512_mask_expandloadu_epi32(kept, static_cast<__mmask16>(bits), next);
}
#else
template <class Number>
xsimd::batch<Number> expand(std::uint32_t bits, const Number* next, const xsimd::batch<Number>& kept) {
  std::array<Number, xsimd::batch<Number>::size> values;
  kept.store_unaligned(values.data());
  for (; bits != 0; bits &= bits - 1) values[static_cast<std::size_t>(std::countr_zero(bits))] = *next++;
  return xsimd::batch<Number>::load_unaligned(values.data());
}
#endif

template <class A>
void store_lanes(const xsimd::batch<float, A>& x, double* out) {
  std::array<float, lanes<xsimd::batch<float, A>>> values{};
  x.store_unaligned(values.data());
  std::copy(values.begin(), values.end(), out);
}

template <class A>
void load_lanes(const double* in, xsimd::batch<float, A>& x) {
  std::array<float, lanes<xsimd::batch<float, A>>> values{};
  std::transform(in, in + values.size(), values.begin(), [](double value) { return static_cast<float>(value); });
  x = xsimd::batch<float, A>::load_unaligned(values.data());
}

namespace detail {

/// Looks up a table that fits into one or two registers by a permutation of their words, which
/// takes a fraction of a gather's time. The table is padded to whole registers. Returns false for
/// other sizes.
template <class A>
bool look_up(const float*, std::size_t, const xsimd::batch<std::int32_t, A>&, xsimd::batch<float, A>&) {
  return false;
}
#if defined(__AVX512F__)
inline bool look_up(const float* table, std::size_t size, const xsimd::batch<std::int32_t>& i,
                    xsimd::batch<float>& found) {
  if (size > 32) return false;
  const __m512 first = _mm512_loadu_ps(table);
  found =
      size <= 16 ? _mm512_permutexvar_ps(i, first) : _mm512_permutex2var_ps(first, i, _mm512_loadu_ps(table + 16));
  return true;
}
#elif defined(__AVX2__)
inline bool look_up(const float* table, std::size_t size, const xsimd::batch<std::int32_t>& i,
                    xsimd::batch<float>& found) {
  if (size > 8) return false;
  found = _mm256_permutevar8x32_ps(_mm256_loadu_ps(table), i);
  return true;
}
#endif

}  // namespace detail

/// Subtracts the nearest quarter turn, exactly. The rest is at most an eighth of a turn, where
/// short polynomials are accurate.
/// Source   Cephes (Moshier 1992), sinf and cosf
template <class A>
std::pair<xsimd::batch<float, A>, xsimd::batch<float, A>> sine_and_cosine_of_turn(
    const xsimd::batch<float, A>& turn) {
  using Real = xsimd::batch<float, A>;
  const Real quarter = xsimd::nearbyint(turn * 4.0f);  // 0 to 4
  const Real a = (turn - quarter * 0.25f) * (2 * pi<Real>);
  const Real a2 = a * a;
  const Real sine = a + a * a2 * ((Real(-1.9515295891e-4f) * a2 + 8.3321608736e-3f) * a2 - 1.6666654611e-1f);
  const Real cosine =
      1.0f - 0.5f * a2 +
      a2 * a2 * ((Real(2.443315711809948e-5f) * a2 - 1.388731625493765e-3f) * a2 + 4.166664568298827e-2f);
  const auto swapped = xsimd::abs(quarter - 2.0f) == Real(1.0f);
  const Real s = select(swapped, cosine, sine);
  const Real c = select(swapped, sine, cosine);
  return {select(xsimd::abs(quarter - 2.5f) < Real(1.0f), -s, s),
          select(xsimd::abs(quarter - 1.5f) < Real(1.0f), -c, c)};
}

/// 0, 1, 2, ... across the lanes.
template <class A>
xsimd::batch<std::uint32_t, A> lane_numbers() {
  constexpr auto numbers = [] {
    std::array<std::uint32_t, xsimd::batch<std::uint32_t, A>::size> n{};
    for (std::size_t i = 0; i < n.size(); ++i) n[i] = static_cast<std::uint32_t>(i);
    return n;
  }();
  return xsimd::batch<std::uint32_t, A>::load_unaligned(numbers.data());
}

namespace detail {

/// xsimd 8 gathers lane by lane even where there is an instruction for it.
#if defined(__AVX512F__)
inline __m512 gather(const float* table, __m512i i) { return _mm512_i32gather_ps(i, table, sizeof(float)); }
#endif
#if defined(__AVX2__)
inline __m256 gather(const float* table, __m256i i) { return _mm256_i32gather_ps(table, i, sizeof(float)); }
inline __m128 gather(const float* table, __m128i i) { return _mm_i32gather_ps(table, i, sizeof(float)); }
#endif

}  // namespace detail

template <class A>
xsimd::batch<float, A> gather(const float* table, const xsimd::batch<std::int32_t, A>& i) {
#if defined(__AVX2__)
  return detail::gather(table, i);
#else
  return xsimd::batch<float, A>::gather(table, i);
#endif
}

}  // namespace fairlight

namespace Eigen {

/// Lets a packet be the scalar of an Eigen vector.
template <class A>
struct NumTraits<xsimd::batch<float, A>> {
  using Real = xsimd::batch<float, A>;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = float;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
  static Real epsilon() { return Real(NumTraits<float>::epsilon()); }
  static Real dummy_precision() { return Real(NumTraits<float>::dummy_precision()); }
  static int digits10() { return NumTraits<float>::digits10(); }
};

}  // namespace Eigen

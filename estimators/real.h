#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <type_traits>
#include <utility>

namespace fairlight {

/// Samplers, geometry and the path tracer are templates over Real: `double`, the readable
/// reference, or a SIMD packet of floats (packet.h). This file holds what differs between the two.
/// A packet type specialises the traits and overloads the functions; a comparison of packets gives
/// a mask.

/// The number type of one lane.
template <class Real>
struct LaneOf {
  using Type = Real;
};
template <class Real>
using Lane = typename LaneOf<Real>::Type;

/// The type of a comparison of two Reals.
template <class Real>
using Mask = decltype(Real() < Real());

/// The number of independent draws in a Real.
template <class Real>
inline constexpr std::size_t lanes = 1;

/// The type of one index per lane.
template <class Real>
struct IndexOf {
  using Type = int;
};
template <class Real>
using Index = typename IndexOf<Real>::Type;

/// The type of one 32-bit word per lane.
template <class Real>
struct WordOf {
  using Type = std::uint32_t;
};
template <class Real>
using Word = typename WordOf<Real>::Type;

/// Rounds a double to Real.
template <class Real>
constexpr Real rounded(double x) {
  return Real(static_cast<Lane<Real>>(x));
}

/// a where the mask holds, b elsewhere. Both are evaluated.
template <class Value>
Value select(bool mask, const Value& a, const Value& b) {
  return mask ? a : b;
}

/// Whether the mask holds in any lane; in all lanes.
inline bool any(bool mask) { return mask; }
inline bool all(bool mask) { return mask; }

/// Whether no lane is infinite or NaN. Tests the bits, as -ffast-math, with which these headers may
/// be compiled, would optimise a comparison away.
inline bool all_finite(double x) {
  constexpr std::uint64_t exponent = 0x7FF0000000000000u;
  return (std::bit_cast<std::uint64_t>(x) & exponent) != exponent;
}
inline bool all_finite(float x) {
  constexpr std::uint32_t exponent = 0x7F800000u;
  return (std::bit_cast<std::uint32_t>(x) & exponent) != exponent;
}

/// The integer part of a nonnegative Real.
inline int to_int(double x) { return static_cast<int>(x); }
inline int to_int(float x) { return static_cast<int>(x); }

/// leading_bits: the first 24 bits of a number in [0,1), at the top of a word. index_of and word_of
/// convert a word below 2^31 to an index, and back.
inline std::uint32_t leading_bits(double x) { return static_cast<std::uint32_t>(x * 0x1p24) << 8; }
inline std::uint32_t leading_bits(float x) { return static_cast<std::uint32_t>(x * 0x1p24f) << 8; }
inline int index_of(std::uint32_t word) { return static_cast<int>(word); }
inline std::uint32_t word_of(int index) { return static_cast<std::uint32_t>(index); }

/// The high and the low 32 bits of a product of words.
inline std::array<std::uint32_t, 2> multiply_high_low(std::uint32_t a, std::uint32_t b) {
  const std::uint64_t product = std::uint64_t{a} * b;
  return {static_cast<std::uint32_t>(product >> 32), static_cast<std::uint32_t>(product)};
}

/// A product modulo 2^16, which is faster. The upper bits of the result are unspecified.
inline std::uint32_t multiply_halves(std::uint32_t a, std::uint32_t b) { return a * b; }

/// The sine and the cosine of a fraction of a full turn, in [0,1].
template <class Real>
std::pair<Real, Real> sine_and_cosine_of_turn(Real turn) {
  const Real angle = 2 * std::numbers::pi_v<Real> * turn;
  return {std::sin(angle), std::cos(angle)};
}

/// The mask as bits.
inline std::uint32_t lane_bits(bool mask) { return mask ? 1 : 0; }

/// Gives the numbers from `next` on to the lanes whose bit is set, in order. The other lanes keep
/// `kept`.
template <class Number>
Number expand(std::uint32_t bits, const Number* next, const Number& kept) {
  return bits != 0 ? *next : kept;
}

/// Where two indices below 2^24 are equal.
template <class Real>
Mask<Real> same_index(int a, int b) {
  return a == b;
}

/// Writes the lanes to `out`, as doubles.
inline void store_lanes(double x, double* out) { *out = x; }
inline void store_lanes(float x, double* out) { *out = static_cast<double>(x); }

/// Reads the lanes from `in`, rounded.
inline void load_lanes(const double* in, double& x) { x = *in; }
inline void load_lanes(const double* in, float& x) { x = static_cast<float>(*in); }

/// Entry i of a table; each lane has its own i.
inline double gather(const double* table, int i) { return table[i]; }
inline float gather(const float* table, int i) { return table[i]; }

template <class Real>
inline constexpr Lane<Real> pi = std::numbers::pi_v<Lane<Real>>;

template <class Real>
inline constexpr Lane<Real> infinity = std::numeric_limits<Lane<Real>>::infinity();

/// The spacing of Reals just above 1.
template <class Real>
inline constexpr Lane<Real> ulp = std::numeric_limits<Lane<Real>>::epsilon();

}  // namespace fairlight

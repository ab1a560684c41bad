#pragma once

#include <array>
#include <cstdint>

#include <fairlight/estimators/point_set.h>

namespace fairlight {

/// The number of dimensions taken from Sobol's sequence. Higher ones come in groups of four (see
/// OwenSobol).
inline constexpr std::uint32_t sobol_dimensions = 64;

/// Joe and Kuo's direction numbers, taken from Boost's engine: [dimension][k] is the contribution
/// of bit k of a point's number.
using SobolDirections = std::array<std::array<std::uint32_t, 32>, sobol_dimensions>;
const SobolDirections& sobol_directions();

/// One coordinate of Sobol's points, not scrambled, with 32 binary digits. The points are in
/// natural order, not in Gray code order.
/// Source   Sobol' 1967; Joe and Kuo 2008, "Constructing Sobol sequences with better
///          two-dimensional projections"
template <class W>
W sobol(std::uint32_t dimension, W point) {
  W digits(0u);
  for (const std::uint32_t direction : sobol_directions()[dimension]) {
    if (!any(point != W(0u))) break;
    digits ^= (W(0u) - (point & W(1u))) & W(direction);
    point = point >> 1;
  }
  return digits;
}

/// Reverses the bits.
template <class W>
W reverse_bits(W x) {
  x = (x >> 16) | (x << 16);
  x = ((x & W(0xFF00FF00u)) >> 8) | ((x & W(0x00FF00FFu)) << 8);
  x = ((x & W(0xF0F0F0F0u)) >> 4) | ((x & W(0x0F0F0F0Fu)) << 4);
  x = ((x & W(0xCCCCCCCCu)) >> 2) | ((x & W(0x33333333u)) << 2);
  return ((x & W(0xAAAAAAAAu)) >> 1) | ((x & W(0x55555555u)) << 1);
}

// scramble_upwards follows Owen's law for two points, so a mean has the same variance: if shift and
// factor are uniform, every number is uniform (by the shift alone), and two numbers that first
// differ at digit j become a uniform pair among those that first differ there. For three points the
// law is nearly Owen's: without x (2x + 1), equal steps would stay equal, and rare sets would carry
// all of the error.

/// Owen's nested scrambling of binary digits: each digit is flipped or not, depending on the digits
/// before it and on the seeds. On reversed digits this is an operation that carries upwards only:
/// an odd factor, a shift, and x (2x + 1), which is one to one.
/// Source   Owen 1995, 2003 ("Variance with alternative scramblings of digital nets": pairs of
///          points decide the variance); Laine and Karras 2011 (carries); Rivest et al. 1998, "The
///          RC6 block cipher" (x (2x + 1))
template <class W, class Seed>
W scramble_upwards(const W& reversed, const Seed& shift, const Seed& factor) {
  const W x = reversed * (W(factor) | W(1u)) + W(shift);
  return x * (x + x + W(1u));
}
template <class W>
W nested_scramble(const W& digits, std::uint32_t shift, std::uint32_t factor) {
  return reverse_bits(scramble_upwards(reverse_bits(digits), shift, factor));
}

/// Sobol's points, Owen-scrambled: 2^k points have one in each elementary interval, as far as
/// Sobol's sequence does, uniform within it.
/// Formula  u_d = scramble_d(sobol_d(i)), with seeds for every (replicate, dimension)
/// Measure  the unit cube
/// Domain   n from 1 to 2^28 (else std::invalid_argument); the points are a net if n is a power of
///          two
/// Random   for each two dimensions: four words per replicate, four per point
/// Source   Owen 1995, "Randomly permuted (t,m,s)-nets and (t,s)-sequences"; Burley 2020
template <class Real>
class OwenSobol {
  // A number has 32 scrambled digits. In double 21 random digits follow, as the scrambling would
  // continue: different points have differed by then. Packets keep the first 24. Dimensions from 64
  // on come in groups of four, each the first four dimensions with new scrambling and a new order;
  // the order scrambles the points' numbers, so aligned blocks of 2^k points stay together.
 public:
  using Scalar = Real;

  OwenSobol(const StreamKey& key, std::uint32_t replicate, std::uint32_t n)
      : replicate_(key, replicate), n_(checked_size(n)) {}

  std::uint32_t size() const { return n_; }
  PointSource<OwenSobol> source(std::uint32_t first) const { return {*this, first}; }

  /// Dimensions 2k and 2k + 1 of the points.
  std::array<Real, 2> pair(const Word<Real>& points, std::uint32_t k) const {
    const auto [dimension, order] = place(points, k);
    const auto seeds = replicate_.shared(k);
    std::array<Word<Real>, 4> below{};
    if constexpr (lanes<Real> == 1) below = replicate_.own(points, k);
    return {unit_number(nested_scramble(sobol(dimension, order), seeds[0], seeds[1]), below[0]),
            unit_number(nested_scramble(sobol(dimension + 1, order), seeds[2], seeds[3]), below[1])};
  }

 private:
  // Where pair k comes from in the sequence: its first dimension, and the points' numbers.
  struct Place {
    std::uint32_t dimension;
    Word<Real> order;
  };

  Place place(const Word<Real>& points, std::uint32_t k) const {
    if (k < sobol_dimensions / 2) return {2 * k, points};
    const auto seeds = replicate_.shared_by_group(k / 2);
    return {2 * (k % 2), nested_scramble(points, seeds[0], seeds[1])};
  }

  Replicate replicate_;
  std::uint32_t n_;
};

}  // namespace fairlight

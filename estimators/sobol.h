#pragma once

#include <array>
#include <cstdint>

#include <fairlight/estimators/point_set.h>

namespace fairlight {

/// How many dimensions of Sobol's sequence are used as they are; those beyond come in fours (see OwenSobol).
inline constexpr std::uint32_t sobol_dimensions = 64;

/// Joe and Kuo's direction numbers, read off Boost's engine: [dimension][k] is what bit k of a
/// point's number contributes.
using SobolDirections = std::array<std::array<std::uint32_t, 32>, sobol_dimensions>;
const SobolDirections& sobol_directions();

/// A coordinate of Sobol's points, not scrambled: 32 binary digits. Points come in the order of their numbers.
/// Source: Sobol' 1967; Joe and Kuo 2008, "Constructing Sobol sequences with better two-dimensional projections".
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

/// The bits in reverse order.
template <class W>
W reverse_bits(W x) {
  x = (x >> 16) | (x << 16);
  x = ((x & W(0xFF00FF00u)) >> 8) | ((x & W(0x00FF00FFu)) << 8);
  x = ((x & W(0xF0F0F0F0u)) >> 4) | ((x & W(0x0F0F0F0Fu)) << 4);
  x = ((x & W(0xCCCCCCCCu)) >> 2) | ((x & W(0x33333333u)) << 2);
  return ((x & W(0xAAAAAAAAu)) >> 1) | ((x & W(0x55555555u)) << 1);
}

/// Owen's nested scrambling of binary digits: each digit is flipped or not, as the digits before it and the seeds say. On reversed digits
/// these are operations that carry upwards only: an odd factor and a shift, and x (2x + 1). Where shift and factor are
/// uniform, a number becomes any, each as likely as any other, by the shift alone; and two that part after j digits become any two that part there.
/// That is the law of Owen's scrambling for two points, so a mean has the variance that it has under his. Three points
/// have it nearly: by factor and shift alone equal steps would stay equal, and rare sets would have all of the error.
/// Source: Owen 1995, 2003 ("Variance with alternative scramblings of digital nets": what two points have in common decides); Laine
/// and Karras 2011 (carries); Rivest et al. 1998, "The RC6 block cipher" (x (2x + 1) is one to one).
template <class W, class Seed>
W scramble_upwards(const W& reversed, const Seed& shift, const Seed& factor) {
  const W x = reversed * (W(factor) | W(1u)) + W(shift);
  return x * (x + x + W(1u));
}
template <class W>
W nested_scramble(const W& digits, std::uint32_t shift, std::uint32_t factor) {
  return reverse_bits(scramble_upwards(reverse_bits(digits), shift, factor));
}

/// Sobol's points, Owen-scrambled: of 2^k points, one in each elementary interval as far as Sobol's sequence has it
/// so, and uniform within. A number has 32 scrambled digits; in double 21 random ones follow, as the scrambling
/// would go on, since points that differ have parted by then. Packets keep the first 24.
/// Dimensions from 64 on come in fours, each four being the sequence's first, scrambled anew and in an order of its
/// own: the points' numbers are scrambled too, so that aligned blocks of 2^k stay together.
/// Formula  u_d = scramble_d(sobol_d(i)), with seeds for every (replicate, dimension)
/// Measure  the unit cube
/// Domain   n from 1 to 2^28 (throws std::invalid_argument otherwise); a power of two for the points to be a net
/// Random   four words for two dimensions of a replicate, and as many for those of a point
/// Source   Owen 1995, "Randomly permuted (t,m,s)-nets and (t,s)-sequences"; Burley 2020
template <class Real>
class OwenSobol {
 public:
  using Scalar = Real;

  OwenSobol(const StreamKey& key, std::uint32_t replicate, std::uint32_t n)
      : replicate_(key, replicate), n_(checked_size(n)) {}

  std::uint32_t size() const { return n_; }
  PointSource<OwenSobol> source(std::uint32_t first) const { return {*this, first}; }

  /// Dimensions 2k and 2k + 1 of points.
  std::array<Real, 2> pair(const Word<Real>& points, std::uint32_t k) const {
    const auto [dimension, order] = place(points, k);
    const auto seeds = replicate_.shared(k);
    std::array<Word<Real>, 4> below{};
    if constexpr (lanes<Real> == 1) below = replicate_.own(points, k);
    return {unit_number(nested_scramble(sobol(dimension, order), seeds[0], seeds[1]), below[0]),
            unit_number(nested_scramble(sobol(dimension + 1, order), seeds[2], seeds[3]), below[1])};
  }

 private:
  // Where in the sequence pair k is found: its first dimension, and the points' numbers there.
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

#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace fairlight {

/// Exact sums of at most 64 floats and of their squares, computed in doubles. It needs draws whose
/// exponents lie close together. The unit is the last digit of the lowest exponent. A square is
/// split into two parts, so that each part has room to be summed without rounding. Inline, to be
/// compiled for the caller's instruction set: with the widest it takes a third of the time.
class ExactSums {
 public:
  __extension__ using Int128 = __int128;
  static constexpr std::size_t most = 64;
  static constexpr int finest = -96;  ///< draws are multiples of 2^finest, as in ExactMoments

  /// The sums, or nothing for draws that must be added one by one: more than 64, all of them zero,
  /// a value that ExactMoments does not accept or that is not a multiple of 2^-96, or exponents too
  /// far apart. Always nothing under -ffast-math, which would remove (x + shift) - shift.
  static std::optional<ExactSums> of([[maybe_unused]] std::span<const float> draws) {
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__)
    return std::nullopt;
#else
    if (draws.size() > most) return std::nullopt;
    std::uint32_t largest = 0;
    std::uint32_t least_but_zero = 0xFFFFFFFF;  // the least bits of a nonzero draw, less one
    for (float x : draws) {
      const auto bits = std::bit_cast<std::uint32_t>(x);
      largest = std::max(largest, bits);
      least_but_zero = std::min(least_but_zero, bits - 1);
    }
    const std::uint32_t lowest = (least_but_zero + 1) >> 23;
    const bool refused = largest >= std::bit_cast<std::uint32_t>(0x1p64f);
    if (refused || lowest < whole || (largest >> 23) > lowest + range) return std::nullopt;
    return ExactSums(draws, lowest);
#endif
  }

  std::uint64_t count() const { return count_; }
  /// The sum is in units of 2^unit, the sum of squares in units of 2^(2 unit).
  int unit() const { return unit_; }
  Int128 sum() const { return units(sum_, unit_); }
  Int128 squares() const { return (Int128{units(upper_, 2 * unit_ + split)} << split) + units(lower_, 2 * unit_); }

 private:
  // A float is significand * 2^(exponent - 150) with significand < 2^24. The draws are zero or have
  // exponents from `lowest` to `lowest + range`, so their sum is below 2^53 units. The upper parts
  // of the squares are multiples of 2^48 units, so their sum is exact too.
  static constexpr std::uint32_t range = 23;
  // From this exponent on, all floats are multiples of 2^finest.
  static constexpr std::uint32_t whole = 150 + finest;
  static constexpr int split = 48;
  static constexpr std::size_t width = 8;  // partial sums, for SIMD registers
  using Parts = std::array<double, width>;

  ExactSums(std::span<const float> draws, std::uint32_t lowest)
      : count_(draws.size()), unit_(static_cast<int>(lowest) - 150) {
    const double shift = 1.5 * power_of_two(2 * unit_ + split + 52);
    for (; draws.size() >= width; draws = draws.subspan(width)) {
      for (std::size_t k = 0; k < width; ++k) add(draws[k], shift, k);
    }
    for (std::size_t k = 0; k < draws.size(); ++k) add(draws[k], shift, k);
  }

  // Adding 1.5 * 2^52 times the upper unit rounds the square to a multiple of that unit.
  void add(float draw, double shift, std::size_t k) {
    const auto x = static_cast<double>(draw);
    const double square = x * x;
    const double upper = (square + shift) - shift;
    sum_[k] += x;
    upper_[k] += upper;
    lower_[k] += square - upper;
  }

  static double power_of_two(int exponent) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
  }

  static std::int64_t units(const Parts& parts, int unit) {
    double sum = 0;
    for (const double part : parts) sum += part;
    return static_cast<std::int64_t>(sum * power_of_two(-unit));
  }

  std::uint64_t count_;
  int unit_;
  Parts sum_{}, upper_{}, lower_{};
};

}  // namespace fairlight

#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace fairlight {

/// Floats and their squares, summed up to the last digit by doubles: of few draws, whose exponents are not far from the lowest, in units
/// of that one's last digit. A square is split where both parts have room to add up. All of it is here to be compiled for the
/// instructions of whoever has the floats: by the widest it takes a third of the time.
class ExactSums {
 public:
  __extension__ using Int128 = __int128;
  static constexpr std::size_t most = 64;
  static constexpr int finest = -96;  ///< draws are multiples of 2^finest, as in ExactMoments

  /// Of at most so many draws. Nothing for more, or where they must be looked at one by one: those that are no draws of ExactMoments,
  /// none but zeros, finer than its unit, or too far apart.
  /// Nothing at all in code that is compiled with -ffast-math, which leaves out (x + shift) - shift.
  static std::optional<ExactSums> of([[maybe_unused]] std::span<const float> draws) {
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__)
    return std::nullopt;
#else
    if (draws.size() > most) return std::nullopt;
    std::uint32_t largest = 0;
    std::uint32_t least_but_zero = 0xFFFFFFFF;  // less one
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
  /// The unit of the sum is 2^unit, that of the squares its square.
  int unit() const { return unit_; }
  Int128 sum() const { return units(sum_, unit_); }
  Int128 squares() const { return (Int128{units(upper_, 2 * unit_ + split)} << split) + units(lower_, 2 * unit_); }

 private:
  // A float is significand * 2^(exponent - 150), its significand below 2^24. Draws are zeros, or of exponents from `lowest` to
  // lowest + range, so that their sum is below 2^53 units; 2^48 is the unit of the squares' upper parts, whose sum is then too.
  static constexpr std::uint32_t range = 23;
  static constexpr std::uint32_t whole = 150 + finest;  // from this exponent on all are multiples of 2^finest
  static constexpr int split = 48;
  static constexpr std::size_t width = 8;  // side by side, in registers
  using Parts = std::array<double, width>;

  ExactSums(std::span<const float> draws, std::uint32_t lowest)
      : count_(draws.size()), unit_(static_cast<int>(lowest) - 150) {
    const double shift = 1.5 * power_of_two(2 * unit_ + split + 52);
    for (; draws.size() >= width; draws = draws.subspan(width)) {
      for (std::size_t k = 0; k < width; ++k) add(draws[k], shift, k);
    }
    for (std::size_t k = 0; k < draws.size(); ++k) add(draws[k], shift, k);
  }

  // To add 1.5 * 2^52 times the upper unit leaves no digit below that unit.
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

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <fairlight/stats/exact_sums.h>

namespace fairlight {

/// Count, sum and sum of squares of nonnegative draws, without any rounding after a draw has entered: however the
/// draws are split into parts, and in whatever order the parts are merged, the same words come out.
///
/// A draw in [0, 2^64) enters as the nearest multiple of 2^-96 (so draws from 1e-13 up enter as they are), and both
/// sums are fixed-point integers: 192 bits of unit 2^-96, 384 bits of unit 2^-192. The variance is computed from
/// n sum(x^2) - (sum x)^2 as an integer, which is never negative, and is zero when all draws are equal.
/// Source: Kulisch and Miranker 1981 (the long accumulator).
class ExactMoments {
 public:
  static constexpr std::size_t word_count = 10;
  /// The whole state: the count, three words of the sum, six of the sum of squares, least significant first.
  using Words = std::array<std::uint64_t, word_count>;

  ExactMoments() = default;
  explicit ExactMoments(const Words& words) : words_(words) {}

  /// Throws std::domain_error when x is negative, not a number, or 2^64 and more; the state is then unchanged.
  /// Throws std::overflow_error when the sum reaches 2^96.
  void add(double x);

  /// As if each of the draws were added alone, floats in a few cycles each. Throws as they would; none is added where one is refused.
  void add(std::span<const float> draws) {
    if (const auto sums = ExactSums::of(draws)) return add(*sums);
    add_in_parts(draws);
  }
  void add(std::span<const double> draws);

  /// As if each of the draws were added alone that are summed up. Throws as add does for the sum.
  void add(const ExactSums& draws);

  /// Throws std::overflow_error when the sum reaches 2^96.
  void merge(ExactMoments other);

  std::uint64_t count() const { return words_[0]; }
  /// 0 before the first draw.
  double mean() const;
  /// The unbiased variance of one draw; infinity with fewer than two draws, where nothing is known of it.
  double variance() const;
  /// The standard error of the mean, sqrt(variance / count); infinity with fewer than two draws.
  double standard_error() const;

  const Words& words() const { return words_; }
  bool operator==(const ExactMoments&) const = default;

 private:
  void add_in_parts(std::span<const float> draws);

  Words words_{};
};

}  // namespace fairlight

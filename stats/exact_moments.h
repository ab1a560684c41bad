#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <fairlight/stats/exact_sums.h>

namespace fairlight {

/// The count, sum and sum of squares of nonnegative draws, as integers. They do not depend on how
/// the draws are split into parts, or on the order in which the parts are merged.
/// A draw in [0, 2^64) is rounded to the nearest multiple of 2^-96 (draws from 1e-13 up are exact);
/// sums and merges do not round. The sum is fixed-point with 192 bits in units of 2^-96, the sum of
/// squares with 384 bits in units of 2^-192. The variance comes from the integer n sum(x^2) - (sum
/// x)^2: never negative, and 0 when all draws are equal.
/// Source   Kulisch and Miranker 1981 (the long accumulator)
class ExactMoments {
 public:
  static constexpr std::size_t word_count = 10;
  /// The whole state: the count, three words of the sum and six of the sum of squares, each least
  /// significant word first.
  using Words = std::array<std::uint64_t, word_count>;

  ExactMoments() = default;
  explicit ExactMoments(const Words& words) : words_(words) {}

  /// Throws std::domain_error when x is negative, NaN, or 2^64 or more; the state is then
  /// unchanged.
  /// Throws std::overflow_error when the sum reaches 2^96.
  void add(double x);

  /// The same as adding each draw alone, in a few cycles per float. Throws as that would; if a draw
  /// is not accepted, none is added.
  void add(std::span<const float> draws) {
    if (const auto sums = ExactSums::of(draws)) return add(*sums);
    add_in_parts(draws);
  }
  void add(std::span<const double> draws);

  /// The same as adding each of the summed draws alone. Throws std::overflow_error when the sum
  /// reaches 2^96.
  void add(const ExactSums& draws);

  /// Throws std::overflow_error when the sum reaches 2^96.
  void merge(ExactMoments other);

  std::uint64_t count() const { return words_[0]; }
  /// 0 before the first draw.
  double mean() const;
  /// The unbiased variance of one draw; infinite with fewer than two draws.
  double variance() const;
  /// The standard error of the mean, sqrt(variance / count); infinite with fewer than two draws.
  double standard_error() const;

  const Words& words() const { return words_; }
  bool operator==(const ExactMoments&) const = default;

 private:
  void add_in_parts(std::span<const float> draws);

  Words words_{};
};

}  // namespace fairlight

#include <cmath>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/estimators/padded_sobol.h>

namespace fairlight {
namespace {

RC_GTEST_PROP(SecondSobol, IsTheSequencesSecondDimension, (std::uint32_t point)) {
  RC_ASSERT(reverse_bits(second_sobol_reversed(point)) == sobol(1u, point));
}

// Every elementary interval 2^-a x 2^-(m-a) has one point of a set; and so have the 2^m intervals of the number alone.
RC_GTEST_PROP(PaddedSobol, HasOnePointInEveryElementaryInterval,
              (std::uint64_t seed, std::uint32_t pixel, std::uint32_t vertex, std::uint32_t b)) {
  const int m = *rc::gen::inRange(0, 11);
  const std::uint32_t n = 1u << m;
  const PaddedSobol numbers(StreamKey(seed, "test"), n);
  std::vector<Five<double>> points;
  for (std::uint32_t i = 0; i < n; ++i) points.push_back(numbers.block<double>({pixel, 5 * n + i, vertex}, b));
  for (const std::size_t d : {0u, 2u}) {
    for (int a = 0; a <= m; ++a) {
      std::set<std::pair<int, int>> intervals;
      for (const auto& u : points)
        intervals.insert({static_cast<int>(u[d] * (1 << a)), static_cast<int>(u[d + 1] * (1 << (m - a)))});
      RC_ASSERT(intervals.size() == n);
    }
  }
  std::set<int> strata;
  for (const auto& u : points) strata.insert(static_cast<int>(u[4] * n));
  RC_ASSERT(strata.size() == n);
}

RC_GTEST_PROP(PaddedSobol, GivesPacketsTheSameNumbersInTwentyFourDigits,
              (std::uint64_t seed, std::uint32_t pixel, std::uint32_t sample, std::uint32_t vertex)) {
  using W = Word<Packet>;
  const PaddedSobol numbers(StreamKey(seed, "test"), 1u << *rc::gen::inRange(0, 11));
  const auto expected = numbers.block<double>({pixel, sample, vertex}, 2);
  const auto packets = numbers.block<Packet>({W(pixel), W(sample), W(vertex)}, 2);
  for (std::size_t d = 0; d < expected.size(); ++d) {
    std::array<double, lanes<Packet>> u{};
    store_lanes(packets[d], u.data());
    RC_ASSERT(u[0] < 1);
    RC_ASSERT(u[0] == std::floor(expected[d] * 0x1p24) * 0x1p-24);
  }
}

// The points come in one order in a pair and in another in the next.
TEST(PaddedSobol, MeetsItsPairsInDifferentOrders) {
  const PaddedSobol numbers(StreamKey(1, "test"), 64);
  int alike = 0;
  for (std::uint32_t i = 0; i < 64; ++i) {
    const auto u = numbers.block<double>({0, i, 1}, 0);
    alike += (u[0] < 0.5) == (u[2] < 0.5) ? 1 : 0;
  }
  EXPECT_GT(alike, 0);
  EXPECT_LT(alike, 64);
}

TEST(PaddedSobol, RefusesSetsThatAreNoPowersOfTwo) {
  EXPECT_THROW(PaddedSobol(StreamKey(1, "test"), 12), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

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

// Every elementary interval 2^-a x 2^-(m-a) holds one point of a set. Each of the 2^m intervals of
// the single number holds one, too.
RC_GTEST_PROP(PaddedSobol, HasOnePointInEveryElementaryInterval,
              (std::uint64_t seed, std::uint32_t pixel, std::uint32_t vertex, std::uint32_t b)) {
  const int m = *rc::gen::inRange(0, 11);
  const std::uint32_t n = 1u << m;
  const PaddedSobol numbers(StreamKey(seed, "test"), n);
  std::vector<SampleBlock<double>> points;
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

// A set of one point has the point 0, so its numbers are scrambled shifts. Four shifts are the
// upper 24 bits of the block's words; the fifth is the lower 8 of three of them.
TEST(PaddedSobol, ShiftsByWordsThatNoTwoNumbersShare) {
  const StreamKey key(1, "test");
  const auto words = Philox<std::uint32_t>::draw({0x80000001u, 5, 6, 7}, key.words());
  const std::array<std::uint32_t, 5> shifts{words[0] >> 8, words[1] >> 8, words[2] >> 8, words[3] >> 8,
                                            (words[0] & 255) << 16 | (words[1] & 255) << 8 | (words[2] & 255)};
  const auto u = PaddedSobol(key, 1).block<double>({7, 5, 6}, 1);
  for (std::size_t d = 0; d < u.size(); ++d)
    EXPECT_EQ(std::floor(u[d] * 0x1p24), reverse_bits(shifts[d] * (2 * shifts[d] + 1)) >> 8) << d;
}

RC_GTEST_PROP(PaddedSobol, HasIndependentDigitsAfterTheTwentyFourth, (std::uint64_t seed, std::uint32_t sample)) {
  const StreamKey key(seed, "test");
  const PathVertex<double> at{7, sample, 6};
  const auto after = independent_digits(key, at, 1);
  const auto u = PaddedSobol(key, 1u << *rc::gen::inRange(0, 11)).block<double>(at, 1);
  for (std::size_t d = 0; d < u.size(); ++d) {
    const double rest = (after[d].high >> 24) * 0x1p-8 + (after[d].low >> 11) * 0x1p-29;
    RC_ASSERT(u[d] * 0x1p24 - std::floor(u[d] * 0x1p24) == rest);
  }
}

// Identifies an order by which points are in the lower half; the digital shift may swap the halves.
TEST(PaddedSobol, HasAnOrderOfItsOwnInEveryPairAndSingleOfEveryBlock) {
  const PaddedSobol numbers(StreamKey(1, "test"), 64);
  std::set<std::uint64_t> orders;
  std::size_t blocks = 0;
  for (const PathVertex<double>& at : {PathVertex<double>{0, 0, 1}, {0, 0, 2}, {0, 64, 1}, {1, 0, 1}}) {
    for (std::uint32_t b = 0; b < 2; ++b, ++blocks) {
      std::array<std::uint64_t, 3> halves{};
      for (std::uint32_t i = 0; i < 64; ++i) {
        const auto u = numbers.block<double>({at.pixel, at.sample + i, at.vertex}, b);
        for (std::size_t k = 0; k < 3; ++k) halves[k] |= std::uint64_t{u[2 * k] < 0.5} << i;
      }
      for (const std::uint64_t half : halves) orders.insert(half & 1 ? half : ~half);
    }
  }
  EXPECT_EQ(orders.size(), 3 * blocks);
}

TEST(PaddedSobol, RefusesSetsThatAreNoPowersOfTwo) {
  EXPECT_THROW(PaddedSobol(StreamKey(1, "test"), 12), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

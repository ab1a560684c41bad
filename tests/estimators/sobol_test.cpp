#include <bit>
#include <map>
#include <set>
#include <vector>

#include <boost/random/sobol.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/estimators/sobol.h>

namespace fairlight {
namespace {

std::uint32_t gray_code(std::uint32_t i) { return i ^ (i >> 1); }

// The first points in three dimensions as Joe and Kuo print them, in Gray code order, times 16.
TEST(Sobol, GivesThePublishedPoints) {
  const std::vector<std::array<double, 3>> published{{0, 0, 0},  {8, 8, 8},   {12, 4, 4},  {4, 12, 12},
                                                     {6, 6, 10}, {14, 14, 2}, {10, 2, 14}, {2, 10, 6},
                                                     {3, 5, 15}, {11, 13, 7}};
  for (std::uint32_t i = 0; i < published.size(); ++i) {
    for (std::uint32_t d = 0; d < 3; ++d) {
      EXPECT_EQ(sobol(d, gray_code(i)) * 0x1p-32, published[i][d] / 16) << "point " << i << " dimension " << d;
    }
  }
}

TEST(Sobol, GivesThePointsOfBoost) {
  boost::random::sobol_engine<std::uint32_t, 32> engine(sobol_dimensions);
  for (std::uint32_t i = 1; i < 2000; ++i) {
    for (std::uint32_t d = 0; d < sobol_dimensions; ++d)
      ASSERT_EQ(sobol(d, gray_code(i)), engine()) << i << ' ' << d;
  }
}

TEST(ReverseBits, ReversesThem) {
  EXPECT_EQ(reverse_bits(1u), 0x80000000u);
  EXPECT_EQ(reverse_bits(0x12345678u), 0x1E6A2C48u);
}

// Two numbers first differ at the same digit before and after, so nets stay nets.
RC_GTEST_PROP(NestedScramble, KeepsHowManyLeadingDigitsAgree,
              (std::uint32_t x, std::uint32_t shift, std::uint32_t factor)) {
  const std::uint32_t y = x ^ (*rc::gen::arbitrary<std::uint32_t>() >> *rc::gen::inRange(0, 32));
  RC_ASSERT(std::countl_zero(x ^ y) ==
            std::countl_zero(nested_scramble(x, shift, factor) ^ nested_scramble(y, shift, factor)));
}

// Over all shifts the scrambled number takes every value once, so it is uniform for any input.
RC_GTEST_PROP(NestedScramble, TakesDifferentShiftsToDifferentNumbers,
              (std::uint32_t x, std::uint32_t a, std::uint32_t b, std::uint32_t factor)) {
  RC_PRE(a != b);
  RC_ASSERT(nested_scramble(x, a, factor) != nested_scramble(x, b, factor));
}

// For five-bit words, over all shifts and odd factors: a pair that first differs at bit j goes to
// every pair that first differs there, equally often.
TEST(ScrambleUpwards, GivesTwoNumbersTheLawOfOwensScrambling) {
  constexpr std::uint32_t n = 32;
  for (std::uint32_t y = 1; y < n; ++y) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> times;
    for (std::uint32_t shift = 0; shift < n; ++shift) {
      for (std::uint32_t half = 0; half < n / 2; ++half) {
        const auto scrambled = [&](std::uint32_t x) { return scramble_upwards(x, shift, 2 * half) % n; };
        const std::uint32_t a = scrambled(3), b = scrambled(3 ^ y);
        ASSERT_EQ(std::countr_zero(a ^ b), std::countr_zero(y));
        ++times[{a, b}];
      }
    }
    const std::size_t places = n * (n / 2 >> std::countr_zero(y));
    EXPECT_EQ(times.size(), places);
    for (const auto& [pair, count] : times)
      EXPECT_EQ(count, n * n / 2 / places) << pair.first << ' ' << pair.second;
  }
}

// x (2x + 1) of 0, 1, 2, 3.
TEST(ScrambleUpwards, KeepsNoEqualSteps) {
  EXPECT_EQ(scramble_upwards(0u, 0u, 1u), 0u);
  EXPECT_EQ(scramble_upwards(1u, 0u, 1u), 3u);
  EXPECT_EQ(scramble_upwards(2u, 0u, 0u), 10u);  // makes the factor odd
  EXPECT_EQ(scramble_upwards(1u, 2u, 1u), 21u);
}

struct Points {
  std::vector<std::vector<double>> at;  // [dimension][point]

  Points(std::uint64_t seed, std::uint32_t n, int dimensions) : at(static_cast<std::size_t>(dimensions)) {
    const OwenSobol<double> set(StreamKey(seed, "test"), 7, n);
    for (std::uint32_t i = 0; i < n; ++i) {
      auto source = set.source(i);
      for (auto& dimension : at) dimension.push_back(source.next());
    }
  }
};

RC_GTEST_PROP(OwenSobol, HasOnePointInEachOfItsIntervalsInEveryDimension, (std::uint64_t seed)) {
  const std::uint32_t n = 1u << *rc::gen::inRange(0, 11);
  for (const auto& dimension : Points(seed, n, 100).at) {
    std::set<int> strata;
    for (double u : dimension) strata.insert(static_cast<int>(u * n));
    RC_ASSERT(strata.size() == n);
  }
}

// Dimensions 0 and 1 are a (0, m, 2)-net: every elementary interval 2^-a x 2^-(m-a) holds one
// point. The first two dimensions of each padded group of four are one, too.
RC_GTEST_PROP(OwenSobol, HasOnePointInEveryElementaryIntervalOfItsFirstTwoDimensions, (std::uint64_t seed)) {
  const int m = *rc::gen::inRange(0, 11);
  const Points points(seed, 1u << m, 74);
  for (const std::size_t d : {0u, 64u, 68u, 72u}) {
    for (int a = 0; a <= m; ++a) {
      std::set<std::pair<int, int>> intervals;
      for (std::size_t i = 0; i < points.at[d].size(); ++i) {
        intervals.insert(
            {static_cast<int>(points.at[d][i] * (1 << a)), static_cast<int>(points.at[d + 1][i] * (1 << (m - a)))});
      }
      RC_ASSERT(intervals.size() == points.at[d].size());
    }
  }
}

// The same four dimensions of the sequence, but in a different order.
TEST(OwenSobol, MeetsItsPaddedDimensionsInAnotherOrder) {
  const Points points(1, 64, 72);
  const auto order = [&](std::size_t d) {
    std::vector<int> strata;
    for (double u : points.at[d]) strata.push_back(static_cast<int>(u * 2));
    return strata;
  };
  EXPECT_NE(order(64), order(68));
  std::vector<int> opposite = order(68);
  for (int& half : opposite) half = 1 - half;
  EXPECT_NE(order(64), opposite);
}

}  // namespace
}  // namespace fairlight

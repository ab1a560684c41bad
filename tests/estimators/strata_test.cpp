#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/estimators/strata.h>

namespace fairlight {
namespace {

RC_GTEST_PROP(Permute, IsAPermutation, (std::uint32_t seed, std::uint32_t rotation)) {
  const std::uint32_t n = *rc::gen::inRange<std::uint32_t>(1, 3000);
  std::set<std::uint32_t> places;
  for (std::uint32_t i = 0; i < n; ++i) places.insert(permute(i, n, seed, rotation));
  RC_ASSERT(places.size() == n);
  RC_ASSERT(*places.rbegin() == n - 1);
}

// For a fixed hash, n equally likely rotations take every number to every place.
RC_GTEST_PROP(Permute, TakesANumberToEveryPlaceByItsRotation, (std::uint32_t seed)) {
  const std::uint32_t n = *rc::gen::inRange<std::uint32_t>(1, 300);
  const std::uint32_t i = *rc::gen::inRange<std::uint32_t>(0, n);
  std::set<std::uint32_t> places;
  for (std::uint64_t turn = 0; turn < n; ++turn) {
    places.insert(permute(i, n, seed, static_cast<std::uint32_t>(((turn << 32) + n - 1) / n)));
  }
  RC_ASSERT(places.size() == n);
}

TEST(InStratum, StaysInItsStratumAtTheEdges) {
  constexpr std::uint32_t ones = 0xFFFFFFFFu;
  EXPECT_EQ(in_stratum(0, 1, 0, 0), 0);
  EXPECT_EQ(in_stratum(0, 1, ones, ones), 1 - 0x1p-53);
  EXPECT_EQ(in_stratum(3, 4, 0, 0), 0.75);
  EXPECT_EQ(in_stratum(2, 4, ones, ones), 0.75 - 0x1p-53);
  EXPECT_EQ(in_stratum(2, 3, ones, ones), 1 - 0x1p-53);
  EXPECT_EQ(in_stratum((1u << 28) - 1, 1u << 28, ones, ones), 1 - 0x1p-53);
}

// The two strata share a step of the grid: floor(N / 3) = (2^53 - 2) / 3 for the last two N of the
// first stratum and the first N of the second.
TEST(InStratum, BeginsWhereTheStratumBeforeEnds) {
  const double third = 0x1.5555555555554p-2;  // (2^53 - 2) / 3 steps of the grid
  EXPECT_EQ(in_stratum(0, 3, 0xFFFFFFFFu, 0xFFFFFFFFu), third);
  EXPECT_EQ(in_stratum(1, 3, 0, 0), third);
  EXPECT_EQ(in_stratum(1, 3, 0, 1u << 11), third + 0x1p-53);
}

RC_GTEST_PROP(InStratum, IsWhereItsStratumIs, (std::uint32_t high, std::uint32_t low)) {
  const std::uint32_t n = *rc::gen::inRange<std::uint32_t>(1, 1u << 28);
  const std::uint32_t stratum = *rc::gen::inRange<std::uint32_t>(0, n);
  const double u = in_stratum(stratum, n, high, low);
  RC_ASSERT(u < 1);
  RC_ASSERT(u >= stratum / double(n) - 0x1p-53);
  RC_ASSERT(u <= (stratum + 1.0) / n);
}

}  // namespace
}  // namespace fairlight

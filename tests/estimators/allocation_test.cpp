#include <limits>
#include <numeric>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/estimators/allocation.h>

namespace fairlight {
namespace {

static_assert(AllocationScore<UniformAllocation>);
static_assert(AllocationScore<AllocationByDeviation>);
static_assert(AllocationScore<AllocationByVariance>);
static_assert(AllocationScore<AllocationByNeighbours>);

using Scores = std::vector<double>;

PixelHistories histories(const std::vector<std::vector<double>>& samples) {
  PixelHistories all;
  for (const auto& pixel : samples) all.push_back(Moments::of(pixel));
  return all;
}

TEST(PixelGrid, HasAPixel) {
  EXPECT_EQ(PixelGrid(3, 2).size(), 6u);
  EXPECT_THROW(PixelGrid(0, 2), std::invalid_argument);
  EXPECT_THROW(PixelGrid(3, 0), std::invalid_argument);
  EXPECT_EQ(PixelGrid(65537, 65535).size(), 0xFFFFFFFFu);
  EXPECT_THROW(PixelGrid(65536, 65536), std::invalid_argument);
  EXPECT_THROW(PixelGrid(std::size_t{1} << 33, std::size_t{1} << 33), std::invalid_argument);
}

TEST(ShareOut, IsInProportionBeyondTheLeast) {
  EXPECT_EQ(share_out(8, {1, 3}, 0), (SampleCounts{2, 6}));
  EXPECT_EQ(share_out(12, {1, 0, 3, 0}, 1), (SampleCounts{3, 1, 7, 1}));
  EXPECT_EQ(share_out(4, {1, 3}, 2), (SampleCounts{2, 2}));
}

TEST(ShareOut, GivesTheLargestRemaindersOneMore) {
  EXPECT_EQ(share_out(10, {1, 2, 4}, 0), (SampleCounts{1, 3, 6}));  // 1.43, 2.86, 5.71
  EXPECT_EQ(share_out(0, {1, 2, 4}, 0), (SampleCounts{0, 0, 0}));
}

TEST(ShareOut, BreaksTiesByIndex) {
  EXPECT_EQ(share_out(7, {5, 5, 5, 5}, 0), (SampleCounts{2, 2, 2, 1}));
  EXPECT_EQ(share_out(3, {1, 2, 1}, 0), (SampleCounts{1, 1, 1}));  // 0.75, 1.5, 0.75
}

TEST(ShareOut, IsEvenWhereNothingIsWanted) { EXPECT_EQ(share_out(9, {0, 0, 0}, 1), (SampleCounts{3, 3, 3})); }

TEST(ShareOut, HoldsForScoresWhoseSumOverflows) {
  constexpr double most = std::numeric_limits<double>::max();
  EXPECT_EQ(share_out(6, {most, most, 1}, 0), (SampleCounts{3, 3, 0}));
  constexpr double denormal = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(share_out(6, {denormal, 2 * denormal, 0}, 0), (SampleCounts{2, 4, 0}));
}

TEST(ShareOut, RefusesWhatItCannotMeet) {
  EXPECT_THROW(share_out(3, {1, 1}, 2), std::invalid_argument);
  EXPECT_THROW(share_out(3, {1, 1}, std::numeric_limits<std::uint64_t>::max()), std::invalid_argument);
  EXPECT_THROW(share_out(3, {}, 0), std::invalid_argument);
  EXPECT_THROW(share_out(3, {1, -1e-300}, 0), std::invalid_argument);
  EXPECT_THROW(share_out(3, {1, std::numeric_limits<double>::infinity()}, 0), std::invalid_argument);
  EXPECT_THROW(share_out(3, {std::numeric_limits<double>::quiet_NaN(), 1}, 0), std::invalid_argument);
}

// Scores from 1e-300 to 1e300, and zeros.
rc::Gen<Scores> any_scores() {
  const auto score =
      rc::gen::map(rc::gen::inRange(-301, 301), [](int e) { return e == -301 ? 0 : std::pow(10.0, e); });
  return rc::gen::nonEmpty(rc::gen::container<Scores>(score));
}

RC_GTEST_PROP(ShareOut, MeetsTheBudgetExactly, ()) {
  const Scores scores = *any_scores();
  const auto least = *rc::gen::inRange<std::uint64_t>(0, 5);
  const auto extra = *rc::gen::oneOf(rc::gen::inRange<std::uint64_t>(0, 1000),
                                     rc::gen::inRange<std::uint64_t>(0, std::uint64_t{1} << 60));
  const std::uint64_t budget = least * scores.size() + extra;
  const SampleCounts counts = share_out(budget, scores, least);
  RC_ASSERT(counts.size() == scores.size());
  RC_ASSERT(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}) == budget);
  for (std::uint64_t count : counts) RC_ASSERT(count >= least);
}

// A pixel's count is its share rounded up or down. The scores are integers, so their sum is a
// multiple of a small part of the largest. The rounding of shares, 2^-53 per pixel, is far below
// 1e-9.
RC_GTEST_PROP(ShareOut, IsWithinOneSampleOfTheShare, ()) {
  const auto scores = *rc::gen::nonEmpty(rc::gen::container<Scores>(
      rc::gen::map(rc::gen::inRange(0, 1000), [](int s) { return static_cast<double>(s); })));
  const double sum = std::accumulate(scores.begin(), scores.end(), 0.0);
  RC_PRE(sum > 0);
  const auto budget = *rc::gen::inRange<std::uint64_t>(0, 10'000);
  const SampleCounts counts = share_out(budget, scores, 0);
  for (std::size_t i = 0; i < scores.size(); ++i) {
    const double share = static_cast<double>(budget) * scores[i] / sum;
    RC_ASSERT(std::abs(static_cast<double>(counts[i]) - share) < 1 + 1e-9);
    for (std::size_t j = 0; j < scores.size(); ++j) RC_ASSERT(scores[i] <= scores[j] || counts[i] >= counts[j]);
  }
}

TEST(UniformAllocation, WantsTheSameEverywhere) {
  EXPECT_EQ(UniformAllocation::of(PixelGrid(2, 1), PixelHistories(2)), (Scores{1, 1}));
}

TEST(AllocationByDeviation, IsTheStandardDeviationOfTheSamples) {
  const auto pilot = histories({{1, 3}, {5, 5}, {0, 4, 2}});
  EXPECT_EQ(AllocationByDeviation::of(PixelGrid(3, 1), pilot), (Scores{std::sqrt(2.0), 0, 2}));
}

TEST(AllocationByVariance, IsTheVarianceOfTheSamples) {
  const auto pilot = histories({{1, 3}, {5, 5}, {0, 4, 2}});
  EXPECT_EQ(AllocationByVariance::of(PixelGrid(3, 1), pilot), (Scores{2, 0, 4}));
}

TEST(AllocationByNeighbours, IsTheMeanContrastWithThoseAround) {
  const auto row = histories({{1}, {5}, {2}});
  EXPECT_EQ(AllocationByNeighbours::of(PixelGrid(3, 1), row), (Scores{4, 3.5, 3}));
  EXPECT_EQ(AllocationByNeighbours::of(PixelGrid(1, 3), row), (Scores{4, 3.5, 3}));
  const auto spot = histories({{0}, {0}, {0}, {0}, {8}, {0}, {0}, {0}, {0}, {0}, {0}, {0}});
  EXPECT_EQ(AllocationByNeighbours::of(PixelGrid(3, 4), spot),
            (Scores{8.0 / 3, 1.6, 8.0 / 3, 1.6, 8, 1.6, 1.6, 1, 1.6, 0, 0, 0}));
}

TEST(AllocationByNeighbours, IsNothingForAPixelAlone) {
  EXPECT_EQ(AllocationByNeighbours::of(PixelGrid(1, 1), histories({{3}})), (Scores{0}));
}

}  // namespace
}  // namespace fairlight

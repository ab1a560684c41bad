#include <limits>

#include <gtest/gtest.h>
#include <support/every_outcome.h>

#include <fairlight/estimators/allocation_stages.h>

namespace fairlight {
namespace {

using testing::one_by_one;

double number(std::size_t pixel, std::uint64_t sample) { return static_cast<double>(10 * pixel + sample); }

TEST(DrawStage, ContinuesWhereTheHistoryEnds) {
  const AllocationPlan plan{PixelGrid(2, 1), 8, 2};
  const PixelHistories pilot = detail::draw_pilot(plan, one_by_one(number));
  EXPECT_EQ(pilot[1].mean(), 10.5);
  const PixelHistories next = detail::draw_stage(one_by_one(number), pilot, {3, 1});
  EXPECT_EQ(next[0].count(), 3u);
  EXPECT_EQ(next[0].mean(), 3);
  EXPECT_EQ(next[1].mean(), 12);
}

TEST(StagedSampling, DividesTheRestEvenlyAmongTheStages) {
  const StagedSampling<UniformAllocation> sampling({PixelGrid(2, 1), 15, 2}, 4, 1);
  EXPECT_EQ(sampling.budget(0), 4u);
  EXPECT_EQ(sampling.budget(1), 4u);
  EXPECT_EQ(sampling.budget(2), 4u);
  EXPECT_EQ(sampling.budget(3), 3u);
}

TEST(StagedSampling, ScoresAllTheSamplesSoFar) {
  // The pilots are 0, 0 and 0, 6, so the second pixel gets all of stage 1. Its samples are then 0,
  // 6, 3, 3, so it gets all of stage 2.
  const auto draw = [](std::size_t pixel, std::uint64_t sample) {
    return pixel == 0 || sample == 0 ? 0.0 : sample == 1 ? 6.0 : 3.0;
  };
  const auto drawn = StagedSampling<AllocationByVariance>({PixelGrid(2, 1), 8, 2}, 3, 0).run(one_by_one(draw));
  ASSERT_EQ(drawn.size(), 3u);
  EXPECT_EQ(drawn[1][0].count(), 0u);
  EXPECT_EQ(drawn[1][1].count(), 2u);
  EXPECT_EQ(drawn[2][1].count(), 2u);
}

TEST(StagedSampling, RefusesAPlanThatCannotBeMet) {
  using Sampling = StagedSampling<AllocationByVariance>;
  const PixelGrid grid(2, 1);
  EXPECT_NO_THROW(Sampling({grid, 8, 2}, 3, 1));
  EXPECT_THROW(Sampling({grid, 7, 2}, 3, 1), std::invalid_argument);
  EXPECT_THROW(Sampling({grid, 8, 1}, 3, 1), std::invalid_argument);
  EXPECT_THROW(Sampling({grid, 8, 2}, 1, 1), std::invalid_argument);
  EXPECT_THROW(Sampling({grid, 3, 2}, 2, 0), std::invalid_argument);
  EXPECT_THROW(Sampling({grid, 8, std::numeric_limits<std::uint64_t>::max()}, 2, 1), std::invalid_argument);
  EXPECT_THROW(StagedSampling<UniformAllocation>({grid, 8, 0}, 2, 1), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

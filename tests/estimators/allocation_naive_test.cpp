#include <gtest/gtest.h>
#include <support/every_outcome.h>

#include <fairlight/estimators/allocation_naive.h>

namespace fairlight {
namespace {

using naive::PooledStages;
using testing::mean_over_every_outcome;
using testing::one_by_one;
using testing::SpikyPixels;

TEST(PooledStages, IsTheMeanOfAllSamples) {
  // The pilots are 0, 0 and 0, 1. Then the second pixel gets all six: the mean of 0 .. 7.
  const auto draw = [](std::size_t pixel, std::uint64_t sample) { return static_cast<double>(pixel * sample); };
  const auto image = PooledStages<AllocationByDeviation>({PixelGrid(2, 1), 10, 2}).estimate(one_by_one(draw));
  EXPECT_EQ(image[0], 0);
  EXPECT_DOUBLE_EQ(image[1], 3.5);
}

TEST(PooledStages, MeetsTheBudgetExactly) {
  testing::CountedDraws counted(6);
  PooledStages<AllocationByVariance>({PixelGrid(3, 2), 47, 3}, 4).estimate(counted.draw());
  EXPECT_EQ(counted.total(), 47u);
  EXPECT_FALSE(counted.repeated());
}

TEST(PooledStages, RefusesABudgetBelowThePilot) {
  EXPECT_NO_THROW(PooledStages<AllocationByVariance>({PixelGrid(2, 1), 4, 2}));
  EXPECT_THROW(PooledStages<AllocationByVariance>({PixelGrid(2, 1), 3, 2}), std::invalid_argument);
}

// A spiky pixel beside a black one: a pilot of 2 each, then 4 more. With probability 2 p (1 - p)
// the pilot has exactly one spike, and the spiky pixel gets all 4; otherwise it gets 2.
TEST(PooledStages, IsBiasedOverEveryOutcome) {
  constexpr double p = 0.1;
  const SpikyPixels pixels{{p, 0}, {10, 1}};
  const auto image =
      mean_over_every_outcome(pixels, 6, PooledStages<AllocationByDeviation>({PixelGrid(2, 1), 8, 2}));
  const double one = 2 * p * (1 - p) * (10 + 4) / 6;
  const double both = p * p * (20 + 2) / 4;
  const double neither = (1 - p) * (1 - p) * (0 + 2) / 4;
  EXPECT_NEAR(image[0], one + both + neither, 1e-12);
  EXPECT_LT(image[0], 0.9);
  EXPECT_EQ(image[1], 0);
}

TEST(PooledStages, IsUnbiasedWhereTheDataDoNotDecide) {
  const SpikyPixels pixels{{0.1, 0.25}, {10, 2}};
  const auto image = mean_over_every_outcome(pixels, 4, PooledStages<UniformAllocation>({PixelGrid(2, 1), 8, 2}));
  EXPECT_NEAR(image[0], 1, 1e-12);
  EXPECT_NEAR(image[1], 0.5, 1e-12);
}

}  // namespace
}  // namespace fairlight

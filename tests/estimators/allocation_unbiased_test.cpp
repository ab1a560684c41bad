#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/every_outcome.h>

#include <fairlight/estimators/allocation_unbiased.h>

namespace fairlight {
namespace {

using testing::CountedDraws;
using testing::mean_over_every_outcome;
using testing::one_by_one;
using testing::SpikyPixels;

const SpikyPixels two{{0.1, 0.25}, {10, 2}};
const SpikyPixels three{{0.1, 0.25, 0.5}, {10, 2, 1}};

// The sums have up to 2^15 terms with a rounding error of 2^-53 each, far below the tolerance.
void expect_the_means(const std::vector<double>& image, const SpikyPixels& pixels) {
  for (std::size_t i = 0; i < image.size(); ++i) EXPECT_NEAR(image[i], pixels.mean(i), 1e-10) << i;
}

template <class Score>
class ByHistory : public ::testing::Test {};
using HistoryScores = ::testing::Types<AllocationByDeviation, AllocationByVariance>;
TYPED_TEST_SUITE(ByHistory, HistoryScores);

TYPED_TEST(ByHistory, DiscardedPilotIsUnbiasedOverEveryOutcome) {
  const AllocationPlan plan{PixelGrid(2, 1), 8, 2};
  expect_the_means(mean_over_every_outcome(two, 5, DiscardedPilot<TypeParam>(plan)), two);
}

TYPED_TEST(ByHistory, FixedStageWeightsAreUnbiasedOverEveryOutcome) {
  const AllocationPlan plan{PixelGrid(2, 1), 10, 2};
  expect_the_means(mean_over_every_outcome(two, 7, FixedStageWeights<TypeParam>(plan, 2)), two);
  expect_the_means(mean_over_every_outcome(two, 6, FixedStageWeights<TypeParam>(plan, 3)), two);
}

TYPED_TEST(ByHistory, CrossedHalvesAreUnbiasedOverEveryOutcome) {
  const AllocationPlan plan{PixelGrid(2, 1), 10, 2};
  expect_the_means(mean_over_every_outcome(two, 6, CrossedHalves<TypeParam>(plan)), two);
}

TEST(ByNeighbours, EveryFormIsUnbiasedOverEveryOutcome) {
  using Score = AllocationByNeighbours;
  const AllocationPlan plan{PixelGrid(3, 1), 9, 1};
  expect_the_means(mean_over_every_outcome(three, 5, DiscardedPilot<Score>(plan)), three);
  expect_the_means(mean_over_every_outcome(three, 5, FixedStageWeights<Score>(plan)), three);
  const AllocationPlan halves{PixelGrid(3, 1), 8, 1};
  expect_the_means(mean_over_every_outcome(three, 4, CrossedHalves<Score>(halves)), three);
}

double number(std::size_t pixel, std::uint64_t sample) { return static_cast<double>(100 * pixel + sample); }

TEST(DiscardedPilot, IsTheMeanOfTheSamplesAfterThePilot) {
  EXPECT_EQ(DiscardedPilot<UniformAllocation>({PixelGrid(2, 1), 8, 2}).estimate(one_by_one(number)),
            (std::vector<double>{2.5, 102.5}));
}

TEST(DiscardedPilot, IsPlainUniformSamplingWithoutAPilot) {
  EXPECT_EQ(DiscardedPilot<UniformAllocation>({PixelGrid(2, 1), 8, 0}).estimate(one_by_one(number)),
            (std::vector<double>{1.5, 101.5}));
}

TEST(DiscardedPilot, DrawsMoreWhereThePilotVaried) {
  // The pilots are 0, 0 and 0, 1; then 1 and 5 samples.
  const auto draw = [](std::size_t pixel, std::uint64_t sample) { return static_cast<double>(pixel * sample); };
  EXPECT_EQ(DiscardedPilot<AllocationByDeviation>({PixelGrid(2, 1), 10, 2}).estimate(one_by_one(draw)),
            (std::vector<double>{0, 4}));
}

TEST(FixedStageWeights, WeighStagesByTheirBudgets) {
  // The pilots are 0, 0 and 0, 1, with weight 4/10. Then sample 2, and samples 2 .. 6, with weight
  // 6/10.
  const auto draw = [](std::size_t pixel, std::uint64_t sample) { return static_cast<double>(pixel * sample); };
  const auto image = FixedStageWeights<AllocationByDeviation>({PixelGrid(2, 1), 10, 2}).estimate(one_by_one(draw));
  EXPECT_EQ(image[0], 0);
  EXPECT_DOUBLE_EQ(image[1], 0.4 * 0.5 + 0.6 * 4);
}

TEST(CrossedHalves, SizeEachOther) {
  // The first half starts at sample 0, and varies in pixel 1; the second starts at sample 12, and
  // varies in pixel 0. Each has a pilot of two per pixel. Then the first half draws 1s in pixel 0
  // only, and the second draws 7s in pixel 1 only.
  const auto draw = [](std::size_t pixel, std::uint64_t sample) {
    if (sample < 2) return pixel == 1 && sample == 1 ? 4.0 : 0.0;
    if (sample == 12 || sample == 13) return pixel == 0 && sample == 13 ? 8.0 : 0.0;
    return pixel == 1 ? 7.0 : 1.0;
  };
  const auto image = CrossedHalves<AllocationByDeviation>({PixelGrid(2, 1), 12, 2}).estimate(one_by_one(draw));
  EXPECT_DOUBLE_EQ(image[0], (2 * 1.0 / 4 + 8.0 / 2) / 2);
  EXPECT_DOUBLE_EQ(image[1], (4.0 / 2 + 2 * 7.0 / 4) / 2);
}

TEST(UnbiasedForms, RefuseBudgetsThatAreTooSmall) {
  const PixelGrid grid(2, 2);
  using Score = AllocationByDeviation;
  EXPECT_NO_THROW(DiscardedPilot<Score>({grid, 12, 2}));
  EXPECT_THROW(DiscardedPilot<Score>({grid, 11, 2}), std::invalid_argument);
  EXPECT_THROW(DiscardedPilot<Score>({grid, 12, 1}), std::invalid_argument);
  EXPECT_THROW(DiscardedPilot<Score>({grid, 12, std::numeric_limits<std::uint64_t>::max()}), std::invalid_argument);
  EXPECT_NO_THROW(FixedStageWeights<Score>({grid, 12, 2}));
  EXPECT_THROW(FixedStageWeights<Score>({grid, 11, 2}), std::invalid_argument);
  EXPECT_NO_THROW(CrossedHalves<Score>({grid, 16, 2}));
  EXPECT_THROW(CrossedHalves<Score>({grid, 15, 2}), std::invalid_argument);
  EXPECT_THROW(CrossedHalves<UniformAllocation>({grid, 16, 0}), std::invalid_argument);
}

TEST(UnbiasedForms, FailOnADrawThatIsNotANumber) {
  const auto nan = [](std::size_t, std::uint64_t) { return std::numeric_limits<double>::quiet_NaN(); };
  EXPECT_THROW(DiscardedPilot<AllocationByVariance>({PixelGrid(2, 1), 8, 2}).estimate(one_by_one(nan)),
               std::invalid_argument);
}

template <class Form>
void check_budget(const Form& form, const AllocationPlan& plan) {
  CountedDraws counted(plan.grid.size());
  form.estimate(counted.draw());
  RC_ASSERT(counted.total() == plan.budget);
  RC_ASSERT(!counted.repeated());
}

template <class Score>
void check_budgets() {
  const PixelGrid grid(*rc::gen::inRange<std::size_t>(1, 9), *rc::gen::inRange<std::size_t>(1, 9));
  const auto pilot = *rc::gen::inRange<std::uint64_t>(2, 5);
  const auto stages = *rc::gen::inRange<std::uint64_t>(2, 6);
  const auto extra = *rc::gen::inRange<std::uint64_t>(0, 300);
  const AllocationPlan plan{grid, (2 * pilot + stages) * grid.size() + extra, pilot};
  check_budget(DiscardedPilot<Score>(plan), plan);
  check_budget(FixedStageWeights<Score>(plan, stages), plan);
  check_budget(CrossedHalves<Score>(plan), plan);
}

RC_GTEST_PROP(UnbiasedForms, MeetTheBudgetExactlyAndUseEverySampleOnce, ()) {
  check_budgets<UniformAllocation>();
  check_budgets<AllocationByDeviation>();
  check_budgets<AllocationByVariance>();
  check_budgets<AllocationByNeighbours>();
}

}  // namespace
}  // namespace fairlight

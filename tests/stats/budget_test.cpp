#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/stats/budget.h>

namespace fairlight {
namespace {

TEST(Budget, IsSharedInProportionToTheWeights) {
  const Budget budget(0.5, {1, 2, 1});
  EXPECT_EQ(budget.share(0), 0.125);
  EXPECT_EQ(budget.share(1), 0.25);
  EXPECT_EQ(budget.share(2), 0.125);
}

RC_GTEST_PROP(Budget, SharesNeverExceedTheTotal, ()) {
  const auto tenths = *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 1000)));
  const std::vector<double> weights(tenths.begin(), tenths.end());
  const Budget budget(1e-6, weights);
  double sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) sum += budget.share(i);
  RC_ASSERT(sum <= 1e-6 * (1 + 1e-12));
}

TEST(Budget, RefusesWhatIsNoProbability) {
  for (double total : {0.0, 1.0, -0.1, 2.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(Budget(total, {1}), std::invalid_argument) << total;
  }
}

TEST(Budget, RefusesNoClaimsAndWeightsThatAreNotPositive) {
  EXPECT_THROW(Budget(0.1, {}), std::invalid_argument);
  EXPECT_THROW(Budget(0.1, {1, 0}), std::invalid_argument);
  EXPECT_THROW(Budget(0.1, {1, -1}), std::invalid_argument);
  EXPECT_THROW(Budget(0.1, {std::numeric_limits<double>::infinity()}), std::invalid_argument);
}

TEST(Budget, HasNoShareForAClaimThatIsNotListed) {
  EXPECT_THROW((void)Budget(0.1, {1, 1}).share(2), std::out_of_range);
}

}  // namespace
}  // namespace fairlight

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <fairlight/stats/common_bias.h>

namespace fairlight {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

// A claim whose levels begin at the margin 1/2, with these wealths in each channel.
EvidenceSum claim(const std::vector<std::vector<Wealth>>& channels) { return EvidenceSum(MarginGrid{2, channels}); }
EvidenceSum one(const Wealth& wealth) { return claim({{wealth}}); }

CommonBias together(const std::vector<EvidenceSum>& claims) {
  CommonBias bias;
  for (const EvidenceSum& each : claims) bias.add(each);
  return bias;
}

TEST(LogMeanExp, IsTheLogarithmOfTheMean) {
  EXPECT_DOUBLE_EQ(log_mean_exp(std::array{std::log(1.0), std::log(3.0)}), std::log(2.0));
  EXPECT_DOUBLE_EQ(log_mean_exp(std::array{2000.0, 2000.0}), 2000);
  EXPECT_EQ(log_mean_exp(std::array{0.0, unlimited}), unlimited);
}

TEST(CommonBias, KnowsNothingWithoutClaims) {
  EXPECT_EQ(CommonBias().excluded(0.01), unlimited);
  EXPECT_FALSE(CommonBias().biased(0.5));
  EXPECT_EQ(together({EvidenceSum()}).claims(), 0u);
}

// The level 1e-8 asks for a log wealth of 18.4, and of 19.9 as the levels from 1/2 to 1 are 3 of 64,
// on each of two sides.
TEST(CommonBias, MultipliesWhatClaimsShow) {
  const EvidenceSum high = one({12, -3, 0, 0}), low = one({-3, 12, 0, 0});
  EXPECT_FALSE(together({high}).biased(1e-8));
  EXPECT_TRUE(together({high, high}).biased(1e-8));
  EXPECT_TRUE(together({high, high}).upward());
  EXPECT_TRUE(together({low, low}).biased(1e-8));
  EXPECT_FALSE(together({low, low}).upward());
  EXPECT_FALSE(together({high, low}).biased(1e-8)) << "biases of different signs do not add up";
}

// The miss rate 0.01 asks for a log wealth of 4.6 on both sides, at a level and at all coarser ones.
TEST(CommonBias, ExcludesWhatClaimsExcludeTogether) {
  const EvidenceSum shows = claim({{{0, 0, 3, 3}, {0, 0, 2, 2}, {0, 0, 1, 1}}});
  EXPECT_EQ(together({shows}).excluded(0.01), unlimited);
  EXPECT_EQ(together({shows, shows}).excluded(0.01), 0.5);
  EXPECT_DOUBLE_EQ(together({shows, shows, shows}).excluded(0.01), std::sqrt(0.125));
  EXPECT_EQ(together({one({0, 0, 9, 1}), one({0, 0, 9, 1})}).excluded(0.01), unlimited) << "one side only";
}

TEST(CommonBias, TakesAClaimsFirstLevelForAllCoarserOnesAndNothingBeyondItsLast) {
  const EvidenceSum coarse = one({0, 0, 3, 3});
  const EvidenceSum fine(MarginGrid{4, {{{0, 0, 3, 3}, {0, 0, 9, 9}}}});
  EXPECT_EQ(together({coarse, fine}).excluded(0.01), 0.5) << "at 1/4 only one claim has evidence";
  EXPECT_EQ(together({fine, fine}).excluded(0.01), margin_of_level(5));
}

// Channels share their draws. Their mean is an e-value against right ones, and the smallest is one
// against a channel that is off.
TEST(CommonBias, TakesTheMeanOfChannelsAgainstAClaimAndTheSmallestForIt) {
  const EvidenceSum channels = claim({{{24, 0, 9, 9}}, {{0, 0, 2, 2}}});
  EXPECT_EQ(together({channels}).excluded(0.01), unlimited);
  EXPECT_EQ(together({channels, channels, channels}).excluded(0.01), 0.5);
  EXPECT_TRUE(together({channels}).biased(1e-8)) << "24 - log 2 is more than 19.9";
  EXPECT_FALSE(together({claim({{{20.2, 0, 0, 0}}, {{0, 0, 0, 0}}})}).biased(1e-8)) << "20.2 - log 2 is less";
}

TEST(CommonBias, IsInfinitelySureOfADrawThatAClaimExcludes) {
  EXPECT_TRUE(together({EvidenceSum(refuted_grid(0.01, 3)), one({-9, -9, 0, 0})}).biased(1e-300));
}

}  // namespace
}  // namespace fairlight

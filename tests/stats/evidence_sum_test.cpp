#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <fairlight/stats/evidence.h>
#include <fairlight/stats/evidence_sum.h>
#include <fairlight/stats/mean_test.h>

namespace fairlight {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
const Wealth nothing{0, 0, 0, 0};

// One channel, of which the first margin_levels have this much.
EvidenceSum run(int first, std::vector<Wealth> margin_grid) {
  return EvidenceSum(MarginGrid{first, {std::move(margin_grid)}});
}
Wealth shows(double log_wealth) { return {0, 0, log_wealth, log_wealth}; }

TEST(Rungs, HalveInTwoStepsAndBeginAtTheRunsMargin) {
  EXPECT_EQ(margin_of_level(0), 1);
  EXPECT_EQ(margin_of_level(2), 0.5);
  EXPECT_EQ(margin_of_level(20), 0x1p-10);
  EXPECT_EQ(first_level(0.5), 2);
  EXPECT_EQ(first_level(0.49), 2);
  EXPECT_EQ(first_level(0.51), 1);
  EXPECT_EQ(first_level(0.999), 0);
  EXPECT_EQ(levels_of_run(1e-3).front(), 19);
  EXPECT_LT(margin_of_level(levels_of_run(1e-3).back()), 1e-3 / 32);
  EXPECT_LT(levels_of_run(1e-300).back(), margin_levels);
}

TEST(EvidenceSum, CertifiesNothingBeforeARun) {
  EXPECT_EQ(EvidenceSum().certified_margin(0.01), unlimited);
  EXPECT_FALSE(EvidenceSum().biased(0.5));
}

// log 100 = 4.6 is asked for at the miss rate 0.01.
TEST(EvidenceSum, AddsUpTheLogarithmsOfRuns) {
  EvidenceSum evidence_sum = run(2, {shows(3), shows(1)});
  EXPECT_EQ(evidence_sum.certified_margin(0.01), unlimited);
  evidence_sum.append(run(2, {shows(3), shows(1)}));
  EXPECT_EQ(evidence_sum.certified_margin(0.01), 0.5);
  for (int i = 0; i < 3; ++i) evidence_sum.append(run(2, {shows(3), shows(1)}));
  EXPECT_DOUBLE_EQ(evidence_sum.certified_margin(0.01), std::sqrt(0.125));
}

TEST(EvidenceSum, TakesARungOnlyAfterThoseAboveIt) {
  EXPECT_EQ(run(2, {shows(4), shows(9)}).certified_margin(0.01), unlimited);
  EXPECT_EQ(run(2, {shows(9), shows(4), shows(9)}).certified_margin(0.01), 0.5);
}

TEST(EvidenceSum, KeepsWhatWasShown) {
  EvidenceSum evidence_sum = run(2, {shows(5)});
  for (int i = 0; i < 2; ++i) evidence_sum.append(run(2, {shows(-3)}));
  EXPECT_EQ(evidence_sum.certified_margin(0.01), 0.5);
  evidence_sum = run(2, {shows(3)});
  EvidenceSum later = run(2, {shows(2)});
  later.append(run(2, {shows(-3)}));
  evidence_sum.append(later);  // 3, 5, 2
  EXPECT_EQ(evidence_sum.certified_margin(0.01), 0.5);
}

TEST(EvidenceSum, NeedsEveryChannelAndBothSides) {
  const MarginGrid one_short{2, {{shows(5)}, {shows(4)}}};
  EXPECT_EQ(EvidenceSum(one_short).certified_margin(0.01), unlimited);
  EXPECT_EQ(run(2, {{0, 0, 5, 4}}).certified_margin(0.01), unlimited);
  EXPECT_EQ(run(2, {{0, 0, 5, unlimited}}).certified_margin(0.01), 0.5);
}

// The mixture of two sides and 64 margin_levels, of which the first stands for those above it too: 3 of 128 parts.
TEST(EvidenceSum, MixesItsEvidenceOfBias) {
  const double alpha = 1e-6;
  const double enough = std::log(128 / 3.0 / alpha);
  EXPECT_FALSE(run(2, {{enough - 0.01, 0, 0, 0}}).biased(alpha));
  EXPECT_TRUE(run(2, {{enough + 0.01, 0, 0, 0}}).biased(alpha));
  EXPECT_TRUE(run(2, {{0, enough + 0.01, 0, 0}}).biased(alpha));
  EXPECT_FALSE(run(2, {nothing, {0, enough + 1, 0, 0}}).biased(alpha)) << "a level that is one part";
  EXPECT_TRUE(run(2, {nothing, {0, enough + 1.1, 0, 0}}).biased(alpha));
  EvidenceSum half = run(2, {{enough / 2 + 0.01, 0, 0, 0}});
  half.append(half);
  EXPECT_TRUE(half.biased(alpha));
}

TEST(EvidenceSum, IsBiasedForGoodByADrawThatIsRuledOut) {
  EvidenceSum evidence_sum(refuted_grid(0.1, 2));
  evidence_sum.append(EvidenceSum(MarginGrid{6, {{{-50, -50, 9, 9}}, {{-50, -50, 9, 9}}}}));
  EXPECT_TRUE(evidence_sum.biased(1e-12));
}

// A run says of coarser margin_levels what it says of its first, and of finer ones than its last nothing.
TEST(EvidenceSum, AddsUpRunsOfUnlikeMargins) {
  EvidenceSum coarse = run(2, {shows(3), shows(3)});
  coarse.append(run(6, {shows(3), shows(3)}));
  EXPECT_EQ(coarse.first(), 2);
  EXPECT_DOUBLE_EQ(coarse.certified_margin(0.01), std::sqrt(0.125));
  EvidenceSum fine = run(6, {shows(3), shows(3)});
  fine.append(run(2, {shows(3), shows(3)}));
  EXPECT_DOUBLE_EQ(fine.certified_margin(0.01), std::sqrt(0.125));
  fine.append(run(6, {shows(3), shows(3)}));
  EXPECT_DOUBLE_EQ(fine.certified_margin(0.01), margin_of_level(7));
}

TEST(EvidenceSum, DoesNotMindHowItsRunsAreGrouped) {
  const std::vector<EvidenceSum> runs{run(4, {{1, 2, 3, -1}, {1, 0, 2, 2}}), run(2, {{-1, 0.5, 1, 4}}),
                                      run(3, {{0.125, 0, -2, 3}, {1, 1, 1, 1}, {2, 2, 2, 2}})};
  EvidenceSum left = runs[0];
  left.append(runs[1]);
  left.append(runs[2]);
  EvidenceSum tail = runs[1];
  tail.append(runs[2]);
  EvidenceSum right = runs[0];
  right.append(tail);
  ASSERT_EQ(left.first(), right.first());
  ASSERT_EQ(left.channels()[0].size(), right.channels()[0].size());
  for (std::size_t r = 0; r < left.channels()[0].size(); ++r) {
    EXPECT_EQ(left.channels()[0][r].total.above_reference, right.channels()[0][r].total.above_reference) << r;
    EXPECT_EQ(left.channels()[0][r].below_upper_margin, right.channels()[0][r].below_upper_margin) << r;
    EXPECT_EQ(left.channels()[0][r].above_lower_margin, right.channels()[0][r].above_lower_margin) << r;
  }
}

TEST(EvidenceSum, RefusesRunsOfOtherChannels) {
  EvidenceSum evidence_sum = run(2, {nothing});
  EXPECT_THROW(evidence_sum.append(EvidenceSum(MarginGrid{2, {{nothing}, {nothing}}})), std::invalid_argument);
}

// Draws that are all 0.5 + x: every process is a product of known factors, with nine tenths of the best bets. Those of the first
// two blocks are made at the largest variance, 0.25, that of the third at half of it (see BettingTest::spread).
TEST(WealthFor, IsWhatOtherBetsOnTheSameBlocksMake) {
  const double x = 0.05;
  BettingTest test({0.5, 0.1, 0, 1}, 1e-6, 0.01);
  for (int i = 0; i < 3; ++i) test.add(std::vector{0.5 + x});
  for (double margin : {0.14, 0.1, 0.03}) {
    const double first = 0.9 * margin / (0.25 + margin * margin);
    const double third = 0.9 * margin / (0.125 + margin * margin);
    const Wealth wealth = test.wealth_for(margin);
    const auto product = [&](double gain) { return 2 * std::log(1 + first * gain) + std::log(1 + third * gain); };
    EXPECT_NEAR(wealth.above_reference, product(x), 1e-12);
    EXPECT_NEAR(wealth.below_reference, product(-x), 1e-12);
    EXPECT_NEAR(wealth.above_lower_margin, product(x + margin), 1e-12);
    EXPECT_NEAR(wealth.below_upper_margin, product(margin - x), 1e-12);
  }
  EXPECT_NEAR(test.wealth_for(0.1).above_lower_margin, test.wealth().above_lower_margin, 1e-12);
  for (double margin : {0.0, -0.1, 0.5, std::nan("")}) EXPECT_THROW(test.wealth_for(margin), std::invalid_argument);
}

TEST(WealthFor, CapsDrawsAndHeedsSlackAndRounding) {
  BettingTest test({.mean = 0.5, .margin = 0.1, .lower = 0, .upper = 1, .tail_slack = 0.005, .rounding = 0.01},
                   1e-6, 0.01);
  test.add(std::vector{1.5});
  const Wealth wealth = test.wealth_for(0.1);
  const double bet = 0.9 * 0.1 / (0.25 + 0.01);
  EXPECT_NEAR(wealth.above_reference, std::log(1 + bet * (1 - 0.01)), 1e-12);
  EXPECT_NEAR(wealth.below_reference, std::log(1 + bet * (-0.505 - 0.01)), 1e-12);
  EXPECT_NEAR(wealth.above_lower_margin, std::log(1 + bet * 1.1), 1e-12);
  EXPECT_NEAR(wealth.below_upper_margin, std::log(1 + bet * (-0.505 + 0.1)), 1e-12);
}

TEST(WealthAtRungs, CountsWhatIsNotClaimedAsShown) {
  const auto margin_grid = [](Sides sides) {
    BettingTest test({.mean = 0.5, .margin = 0.1, .lower = 0, .upper = 1, .sides = sides}, 1e-6, 0.01);
    test.add(std::vector{0.9});
    return wealth_at_levels(test, 0.2, 0.5);
  };
  ASSERT_EQ(margin_grid(Sides::both).size(), levels_of_run(0.2).size());
  EXPECT_GT(margin_grid(Sides::both)[0].above_reference, 0);
  EXPECT_GT(margin_grid(Sides::not_above)[0].above_reference, 0);
  EXPECT_EQ(margin_grid(Sides::not_above)[0].below_reference, 0);
  EXPECT_EQ(margin_grid(Sides::not_above)[0].above_lower_margin, unlimited);
  EXPECT_EQ(margin_grid(Sides::not_below)[0].above_reference, 0);
  EXPECT_EQ(margin_grid(Sides::not_below)[0].below_upper_margin, unlimited);
}

// Halves and thirds in turn, without chance.
MarginGrid ladder_of_test(double shift, double margin, const std::vector<Reference>& references) {
  Evidence evidence;
  Trial trial{"account_test", 1, 1e-6, 0.01, margin};
  trial.evidence = &evidence;
  test_means(trial, references, [shift](std::uint64_t first, std::vector<std::vector<double>>& channels) {
    for (auto& channel : channels) {
      for (std::size_t i = 0; i < channel.size(); ++i) channel[i] = ((first + i) % 2 == 0 ? 0.9 : 1.1) + shift;
    }
  });
  return evidence.margin_grid;
}

TEST(TestMeans, LeavesALadderThatShowsWhatItCertified) {
  const MarginGrid margin_grid = ladder_of_test(0, 0.01, {{1, 0, 2}, {1, 0.5, 3}});
  ASSERT_EQ(margin_grid.channels.size(), 2u);
  EXPECT_EQ(margin_grid.first, first_level(0.01));
  EXPECT_LE(EvidenceSum(margin_grid).certified_margin(0.01), margin_of_level(margin_grid.first));
  EXPECT_FALSE(EvidenceSum(margin_grid).biased(1e-3));
}

TEST(TestMeans, LeavesALadderThatRefutesForGoodAfterADrawOutOfRange) {
  const MarginGrid margin_grid = ladder_of_test(5, 0.01, {{1, 0, 2}, {1, 0, 2}});
  EXPECT_EQ(margin_grid.channels.size(), 2u);
  EXPECT_TRUE(EvidenceSum(margin_grid).biased(1e-300));
}

}  // namespace
}  // namespace fairlight

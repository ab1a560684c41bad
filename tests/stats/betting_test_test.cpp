#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/stats/betting_test.h>

namespace fairlight {
namespace {

constexpr double alpha = 1e-6;
constexpr double beta = 0.01;

MeanHypothesis coin(double margin) { return {0.5, margin, 0, 1}; }

// Blocks of n draws of which each run of `period` has `ones` ones: a sample without chance.
Verdict feed(BettingTest& test, int ones, int period, int blocks) {
  std::vector<double> block(static_cast<std::size_t>(period));
  for (int i = 0; i < ones; ++i) block[static_cast<std::size_t>(i)] = 1;
  for (int i = 0; i < blocks && test.verdict() == Verdict::undecided; ++i) test.add(block);
  return test.verdict();
}

// Half of the draws 0.9, half 1.1, about a mean of 1 + shift.
Verdict verdict_with_rounding(double shift, double rounding) {
  BettingTest test({.mean = 1, .margin = 0.01, .lower = 0, .upper = 2, .rounding = rounding}, 1e-6, 0.01);
  for (int i = 0; i < 100'000 && test.verdict() == Verdict::undecided; ++i) {
    test.add(std::vector{0.9 + shift, 1.1 + shift});
  }
  return test.verdict();
}

TEST(BettingTest, CallsOnlyABiasBeyondTheRoundingOne) {
  EXPECT_EQ(verdict_with_rounding(0.012, 0), Verdict::biased);
  EXPECT_EQ(verdict_with_rounding(-0.012, 0), Verdict::biased);
  EXPECT_EQ(verdict_with_rounding(0.002, 0.0025), Verdict::certified);
  EXPECT_EQ(verdict_with_rounding(-0.002, 0.0025), Verdict::certified);
  EXPECT_EQ(verdict_with_rounding(0.1, 0.0025), Verdict::biased);
  EXPECT_THROW(BettingTest({.mean = 1, .margin = 0.01, .lower = 0, .upper = 2, .rounding = 0.005}, 1e-6, 0.01),
               std::invalid_argument);
  EXPECT_THROW(BettingTest({.mean = 1, .margin = 0.01, .lower = 0, .upper = 2, .rounding = -1e-3}, 1e-6, 0.01),
               std::invalid_argument);
}

TEST(BettingTest, CertifiesDrawsThatAverageToTheMean) {
  BettingTest test(coin(0.01), alpha, beta);
  EXPECT_EQ(feed(test, 5, 10, 100000), Verdict::certified);
  const Interval interval = test.interval();
  EXPECT_GE(interval.lo, 0.49);
  EXPECT_LE(interval.hi, 0.51);
  EXPECT_LT(interval.lo, 0.5);
  EXPECT_GT(interval.hi, 0.5);
}

TEST(BettingTest, FindsDrawsAboveAndBelowTheReference) {
  BettingTest bright(coin(0.01), alpha, beta);
  EXPECT_EQ(feed(bright, 6, 10, 100000), Verdict::biased);
  EXPECT_GT(bright.interval().lo, 0.5);
  BettingTest dark(coin(0.01), alpha, beta);
  EXPECT_EQ(feed(dark, 4, 10, 100000), Verdict::biased);
  EXPECT_LT(dark.interval().hi, 0.5);
}

// One draw in 83 is 0, the others are 1: to bet margin / variance, 0.82, would lose more by the one than it gains by the others.
TEST(BettingTest, CertifiesDespiteRareLosses) {
  const double mean = 82.0 / 83;
  BettingTest test({mean, 0.01 * mean, 0, 1.02}, alpha, beta);
  int draws = 0;
  for (; test.verdict() == Verdict::undecided && draws < test.patience(); ++draws)
    test.add(std::vector{draws % 83 == 41 ? 0.0 : 1.0});
  EXPECT_EQ(test.verdict(), Verdict::certified) << draws;
}

TEST(BettingTest, IsUndecidedBeforeThereIsEvidence) {
  BettingTest test(coin(0.01), alpha, beta);
  EXPECT_EQ(feed(test, 5, 10, 10), Verdict::undecided);
}

// After one block of draws d, before which no bet could be placed on a variance, every process is a product of
// known factors. With draws that are all equal to the mean, U1 and D1 grow by 1 + l margin a block and U0, D0 stay
// at 1.
TEST(BettingTest, NeedsEachAcceptProcessToReachOneOverBeta) {
  const double margin = 0.1;
  BettingTest test(coin(margin), alpha, beta);
  const std::vector<double> mean{0.5};
  double log_wealth = 0;
  int blocks = 0;
  while (test.verdict() == Verdict::undecided) {
    const double spread = 0.25 / std::max(blocks, 1);  // no deviation yet, but what may not have been seen
    const double best = margin / (spread + margin * margin), bet = std::min(0.9 * best, 0.9 / (0.5 - margin));
    log_wealth += std::log1p(bet * margin);
    test.add(mean);
    ++blocks;
    ASSERT_LT(blocks, 1000);
    EXPECT_NEAR(test.wealth().below_upper_margin, log_wealth, 1e-12 * blocks);
    EXPECT_EQ(test.verdict() == Verdict::certified, log_wealth >= std::log(1 / beta));
  }
}

TEST(BettingTest, NamesTheDrawThatIsOutOfItsRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (double wrong : {nan, inf, -inf, -0.1, 1.1}) {
    BettingTest test(coin(0.01), alpha, beta);
    const std::vector<double> good{0, 1};
    const std::vector<double> bad{0, wrong};
    test.add(good);
    try {
      test.add(bad);
      FAIL() << "accepted " << wrong;
    } catch (const BadDraw& error) {
      EXPECT_EQ(error.draw(), 3u);
    }
  }
}

TEST(BettingTest, AcceptsDrawsAboveASoftBound) {
  BettingTest test({0.5, 0.01, 0, 1, 1e-4}, alpha, beta);
  const std::vector<double> draws{0, 5};
  test.add(draws);
  EXPECT_EQ(test.moments().count(), 2u);
  EXPECT_EQ(test.moments().maximum(), 5);
  BettingTest capped({0.5, 0.01, 0, 1, 1e-4}, alpha, beta);
  capped.add(std::vector<double>{0, 1});
  EXPECT_EQ(test.wealth().below_upper_margin, capped.wealth().below_upper_margin)
      << "what is above it counts as the bound";
  EXPECT_GT(test.wealth().above_lower_margin, capped.wealth().above_lower_margin) << "or for itself";
}

TEST(BettingTest, RefusesAHypothesisThatCannotBeTested) {
  EXPECT_THROW(BettingTest({0.5, 0, 0, 1}, alpha, beta), std::invalid_argument);
  EXPECT_THROW(BettingTest({0.5, -0.1, 0, 1}, alpha, beta), std::invalid_argument);
  EXPECT_THROW(BettingTest({0.5, 0.1, 0.45, 1}, alpha, beta), std::invalid_argument);
  EXPECT_THROW(BettingTest({0.5, 0.1, 0, 0.55}, alpha, beta), std::invalid_argument);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  EXPECT_THROW(BettingTest({0.5, 0.1, -infinite, infinite}, alpha, beta), std::invalid_argument);
  EXPECT_THROW(BettingTest({0.5, 0.1, std::nan(""), 1}, alpha, beta), std::invalid_argument);
  EXPECT_THROW(BettingTest({0.5, 0.1, -6e99, 6e99}, alpha, beta), std::invalid_argument);  // its cubes overflow
  EXPECT_NO_THROW(BettingTest({0.5, 0.1, -4e99, 4e99}, alpha, beta));
  EXPECT_THROW(BettingTest({0.5, 0.1, 0, 1, 0.2}, alpha, beta), std::invalid_argument);
  EXPECT_THROW(BettingTest({0.5, 0.1, 0, 1, -1}, alpha, beta), std::invalid_argument);
  EXPECT_THROW(BettingTest(coin(0.1), 0, beta), std::invalid_argument);
  EXPECT_THROW(BettingTest(coin(0.1), alpha, 1), std::invalid_argument);
}

TEST(BettingTest, ChecksDrawsAfterItsVerdictToo) {
  BettingTest test(coin(0.01), alpha, beta);
  ASSERT_EQ(feed(test, 5, 10, 100000), Verdict::certified);
  const std::vector<double> bad{std::numeric_limits<double>::quiet_NaN()};
  EXPECT_THROW(test.add(bad), BadDraw);
}

TEST(BettingTest, RefusesAnEmptyBlock) {
  BettingTest test(coin(0.01), alpha, beta);
  EXPECT_THROW(test.add({}), std::invalid_argument);
}

// What makes the test exact: whatever was drawn before, a process neither gains nor loses in the
// mean over the next draw, if that has the mean that the process bets against. A bet that knew of
// the draw would gain. A coin has such a mean, and two outcomes.
RC_GTEST_PROP(BettingTest, BetsByThePastAlone, ()) {
  const auto past = *rc::gen::container<std::vector<bool>>(rc::gen::arbitrary<bool>());
  const double mean = 0.4, margin = 0.1, never = 1e-100;
  BettingTest test({mean, margin, 0, 1}, never, never);
  for (bool draw : past) test.add(std::vector<double>{draw ? 1.0 : 0.0});
  RC_ASSERT(test.verdict() == Verdict::undecided);
  BettingTest one = test, zero = test;
  one.add(std::vector<double>{1});
  zero.add(std::vector<double>{0});
  const double rounding = 8 * (static_cast<double>(past.size()) + 64) * std::numeric_limits<double>::epsilon();
  const auto is_fair = [&](double Wealth::*process, double heads) {
    const auto growth = [&](const BettingTest& next) {
      return std::exp(next.wealth().*process - test.wealth().*process);
    };
    return std::abs(heads * growth(one) + (1 - heads) * growth(zero) - 1) <= rounding &&
           growth(one) != growth(zero);
  };
  RC_ASSERT(is_fair(&Wealth::above_reference, mean));
  RC_ASSERT(is_fair(&Wealth::below_reference, mean));
  RC_ASSERT(is_fair(&Wealth::below_upper_margin, mean + margin));
  RC_ASSERT(is_fair(&Wealth::above_lower_margin, mean - margin));
}

// With the range from the mean, 1/2, and the standard deviation, 1/2: up to 0.9 sqrt(n) / 2, where
// their bets for two standard errors would be capped, and up to 0.9 / 4 / (0.01 / 2), where those
// for the margin would.
TEST(BettingTest, LetsBlocksGrowUpToWhereTheirBetsWouldBeCapped) {
  BettingTest test(coin(0.01), alpha, beta);
  const auto size_after = [&](int draws) {
    while (test.moments().count() < static_cast<std::uint64_t>(draws)) test.add(std::vector<double>{0, 1});
    return test.block_size();
  };
  EXPECT_EQ(size_after(0), 1u);
  EXPECT_EQ(size_after(16), 1u);
  EXPECT_EQ(size_after(100), 4u);
  EXPECT_EQ(size_after(1000), 14u);
  EXPECT_EQ(size_after(10100), 45u);
}

// Zeros and ones in turn, of mean 1/2: what needs the end that is missing is neither bet on nor shown.
TEST(BettingTest, OfARangeWithOneEndShowsWhatNeedsThatEnd) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const auto after = [](double mean, double lower, double upper) {
    BettingTest test({mean, 0.05, lower, upper}, alpha, beta);
    for (int i = 0; i < 5000; ++i) test.add(std::vector<double>{0, 1});
    return test;
  };
  EXPECT_EQ(after(0.4, 0, infinite).verdict(), Verdict::biased);
  EXPECT_EQ(after(0.6, -infinite, 1).verdict(), Verdict::biased);
  for (const BettingTest& open : {after(0.6, 0, infinite), after(0.5, 0, infinite), after(0.4, -infinite, 1)}) {
    EXPECT_EQ(open.verdict(), Verdict::undecided);
  }
  EXPECT_EQ(after(0.5, 0, infinite).wealth().below_reference, 0);
  EXPECT_EQ(after(0.5, 0, infinite).interval().hi, infinite);
  EXPECT_GT(after(0.5, 0, infinite).interval().lo, 0.4);
}

// The probability of a verdict within n tosses of a coin, by going through all 2^n of them.
double probability_of(Verdict verdict, const MeanHypothesis& hypothesis, double heads, double level, double miss) {
  constexpr unsigned tosses = 16;
  double probability = 0;
  for (unsigned sequence = 0; sequence < 1u << tosses; ++sequence) {
    BettingTest test(hypothesis, level, miss);
    double weight = 1;
    for (unsigned i = 0; i < tosses; ++i) {
      const bool head = (sequence >> i & 1) != 0;
      weight *= head ? heads : 1 - heads;
      test.add(std::vector<double>{head ? 1.0 : 0.0});
    }
    if (test.verdict() == verdict) probability += weight;
  }
  return probability;
}

TEST(BettingTest, AlarmsOnRightCodeNoMoreOftenThanAlpha) {
  for (double mean : {0.3, 0.5, 0.7}) {
    const double alarms = probability_of(Verdict::biased, {mean, 0.25, 0, 1}, mean, 0.3, 1e-9);
    EXPECT_GT(alarms, 0) << mean;
    EXPECT_LE(alarms, 0.3) << mean;
  }
}

TEST(BettingTest, CertifiesABiasOfTheMarginNoMoreOftenThanBeta) {
  for (double bias : {-0.2, 0.2}) {
    const double misses = probability_of(Verdict::certified, {0.5, 0.2, 0, 1}, 0.5 + bias, 1e-9, 0.3);
    EXPECT_GT(misses, 0) << bias;
    EXPECT_LE(misses, 0.3) << bias;
  }
}

}  // namespace
}  // namespace fairlight

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <fairlight/stats/sequential_t_test.h>

// Samples without chance: the quantiles of a law in a scrambled order, of which every long stretch is like the law.
namespace fairlight {
namespace {

const Trial trial{"t_test", 1, 1e-6, 0.01, 0.05};

double scrambled(std::uint64_t i) { return std::fmod((static_cast<double>(i) + 0.5) * 0.6180339887498949, 1.0); }

template <class Quantile>
DrawBlock draws_of(const Quantile& quantile) {
  return [quantile](std::uint64_t first, std::vector<std::vector<double>>& channels) {
    for (std::size_t c = 0; c < channels.size(); ++c) {
      for (std::size_t i = 0; i < channels[c].size(); ++i) channels[c][i] = quantile(scrambled(first + i), c);
    }
  };
}

TEST(SequentialT, CertifiesTheMeanOfAnExponentialLaw) {
  const Finding finding = sequential_t_test(trial, 1, 1, draws_of([](double u, auto) { return -std::log(u); }));
  EXPECT_EQ(finding.verdict, Verdict::certified) << finding.note;
  EXPECT_TRUE(finding.note.starts_with("asymptotic: Student")) << finding.note;
  EXPECT_EQ(finding.guarantee, Guarantee::asymptotic);
  EXPECT_EQ(finding.token, "0000000000000001");
  EXPECT_GT(finding.interval.lo, -0.05);
  EXPECT_LT(finding.interval.hi, 0.05);
}

// No number of draws shows it: the rest of the mean may come in draws too rare to be met.
TEST(SequentialT, CallsNoMeanBiasedWithoutARange) {
  for (double factor : {1.06, 0.94}) {
    const auto draws = draws_of([factor](double u, auto) { return -factor * std::log(u); });
    const Finding finding = sequential_t_test(trial, 1, 1, draws);
    EXPECT_EQ(finding.verdict, Verdict::undecided) << factor;
    EXPECT_NE(finding.note.find(factor > 1 ? "too high" : "too low"), std::string::npos) << finding.note;
    EXPECT_NE(finding.note.find("fairlight::bounded"), std::string::npos) << finding.note;
  }
}

// The end of the range that is known is all that a mean on its far side takes.
TEST(SequentialT, FindsABiasExactlyWhereOneEndOfTheRangeShowsIt) {
  const auto exponential = [](double factor) {
    return draws_of([=](double u, auto) { return -factor * std::log(u); });
  };
  const UnboundedMean nonnegative{1, 1, Sides::both, 0};
  const Finding high = sequential_t_test(trial, nonnegative, exponential(1.06));
  EXPECT_EQ(high.verdict, Verdict::biased);
  EXPECT_EQ(high.guarantee, Guarantee::exact);
  EXPECT_GT(high.interval.lo, 0);
  EXPECT_EQ(sequential_t_test(trial, nonnegative, exponential(0.94)).verdict, Verdict::undecided);
  EXPECT_EQ(sequential_t_test(trial, nonnegative, exponential(1)).verdict, Verdict::certified);
  const UnboundedMean nonpositive{-1, 1, Sides::both, -std::numeric_limits<double>::infinity(), 0};
  EXPECT_EQ(sequential_t_test(trial, nonpositive, exponential(-1.06)).verdict, Verdict::biased);
}

TEST(SequentialT, TestsOneSide) {
  const auto exponential = draws_of([](double u, auto) { return -std::log(u); });
  const Finding below = sequential_t_test(trial, {1.2, 1, Sides::not_above}, exponential);
  EXPECT_EQ(below.verdict, Verdict::certified);
  EXPECT_EQ(below.interval.lo, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(sequential_t_test(trial, {0.8, 1, Sides::not_above}, exponential).verdict, Verdict::undecided);
  EXPECT_EQ(sequential_t_test(trial, {0.8, 1, Sides::not_below}, exponential).verdict, Verdict::certified);
  EXPECT_EQ(sequential_t_test(trial, {1.2, 1, Sides::not_below}, exponential).verdict, Verdict::undecided);
}

// The pilot goes on until it has met about a hundred of the draws that matter.
TEST(SequentialT, MeetsRareDrawsBeforeItPlans) {
  const auto rare = [](double rest) {
    return draws_of([=](double u, auto) { return rest + (u < 1e-3 ? (1 - rest) / 1e-3 : 0); });
  };
  const Trial coarse{"t_test", 1, 1e-6, 0.01, 0.3};
  EXPECT_EQ(sequential_t_test(coarse, 1, 1, rare(0)).verdict, Verdict::certified);
  EXPECT_EQ(sequential_t_test(coarse, 1, 1, rare(0.5)).verdict, Verdict::certified);
}

TEST(SequentialT, SaysHowFarItCameWhenItsDrawsRunOut) {
  const auto uniform = draws_of([](double u, auto) { return u; });
  for (const std::uint64_t last : {100u, 10000u}) {
    const Finding finding =
        sequential_t_test({"t", 1, 1e-6, 0.01, 1e-4}, 0.5, 0.5, [&](std::uint64_t first, auto& channels) {
          if (first > last) throw NoMoreDraws("no more");
          uniform(first, channels);
        });
    EXPECT_EQ(finding.verdict, Verdict::undecided);
    EXPECT_TRUE(finding.note.starts_with("no more; a ")) << finding.note;
    EXPECT_TRUE(finding.interval.lo < 0 && finding.interval.hi > 0 && finding.interval.hi < 1);
  }
}

TEST(SequentialT, RefusesToJudgeAHeavyTail) {
  // Index 3/2: a mean of 3 and no variance.
  const auto draws = draws_of([](double u, auto) { return std::pow(1 - u, -1 / 1.5); });
  const Finding finding = sequential_t_test({"t", 1, 1e-6, 0.01, 0.3}, 3, 3, draws);
  EXPECT_EQ(finding.verdict, Verdict::undecided);
  EXPECT_TRUE(finding.note.starts_with("tail: ")) << finding.note;
}

// 0 but for a rare 10^4 that no one has met has the mean of the constant 0; neither word can be given.
TEST(SequentialT, IsUndecidedWhereThereIsNoVariance) {
  for (double reference : {0.1, 0.2}) {
    const Finding finding = sequential_t_test(trial, reference, 0.1, draws_of([](double, auto) { return 0.1; }));
    EXPECT_EQ(finding.verdict, Verdict::undecided) << reference;
    EXPECT_TRUE(finding.note.starts_with("no variance")) << finding.note;
  }
}

TEST(SequentialT, DoesNotTakeRoundingForABias) {
  const auto rounded = draws_of([](double u, auto) { return u < 0.3 ? 0.1 : std::nextafter(0.1, 1); });
  EXPECT_EQ(sequential_t_test(trial, 0.1, 0.1, rounded).verdict, Verdict::undecided);
}

TEST(SequentialT, RefusesAMarginBeyondReach) {
  const auto any = draws_of([](double u, auto) { return u; });
  EXPECT_THROW(sequential_t_test({"t", 1, 1e-6, 0.01, 1e-9}, 0.5, 0.5, any), std::invalid_argument);
  EXPECT_THROW(sequential_t_test({"t", 1, 1e-6, 0.01, 0}, 0.5, 0.5, any), std::invalid_argument);
}

TEST(SequentialT, NamesADrawThatIsNotFinite) {
  const auto broken = draws_of([](double, auto) { return std::numeric_limits<double>::infinity(); });
  const Finding finding = sequential_t_test(trial, 1, 1, broken);
  EXPECT_EQ(finding.verdict, Verdict::biased);
  EXPECT_NE(finding.note.find("draw 0"), std::string::npos) << finding.note;
}

TEST(SequentialT, RefusesAScaleOfZero) {
  const auto any = draws_of([](double u, auto) { return u; });
  EXPECT_THROW(sequential_t_test(trial, 0, 0, any), std::invalid_argument);
}

TEST(SequentialWelch, ComparesTwoLawsOfUnlikeVariance) {
  const auto alike = draws_of([](double u, std::size_t arm) { return arm == 0 ? 2 * u : 0.9 + 0.2 * u; });
  EXPECT_EQ(sequential_welch_test(trial, 1, alike).verdict, Verdict::certified);
  const auto unlike = draws_of([](double u, std::size_t arm) { return arm == 0 ? 2.2 * u : 0.9 + 0.2 * u; });
  const Finding finding = sequential_welch_test(trial, 1, unlike);
  EXPECT_EQ(finding.verdict, Verdict::undecided);
  EXPECT_NE(finding.note.find("the difference of the means"), std::string::npos) << finding.note;
  EXPECT_NEAR(finding.bias, 0.1, 0.01);
}

}  // namespace
}  // namespace fairlight

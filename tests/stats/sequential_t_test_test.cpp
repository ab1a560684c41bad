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

TEST(SequentialT, FindsABiasUpAndDown) {
  for (double factor : {1.06, 0.94}) {
    const auto draws = draws_of([factor](double u, auto) { return -factor * std::log(u); });
    EXPECT_EQ(sequential_t_test(trial, 1, 1, draws).verdict, Verdict::biased) << factor;
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
  EXPECT_EQ(finding.verdict, Verdict::biased);
  EXPECT_NEAR(finding.bias, 0.1, 0.01);
}

}  // namespace
}  // namespace fairlight

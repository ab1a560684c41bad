#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <fairlight/stats/chi_square.h>

namespace fairlight {
namespace {

using Counts = std::vector<std::uint64_t>;
using Probabilities = std::vector<double>;

TEST(ChiSquare, OfTwoCellsIsTheFamiliarFormula) {
  const ChiSquare result = chi_square(Counts{530, 470}, Probabilities{0.5, 0.5});
  EXPECT_DOUBLE_EQ(result.statistic, 30.0 * 30 / 500 * 2);
  EXPECT_EQ(result.degrees, 1);
  // With one degree of freedom the tail is erfc(sqrt(statistic / 2)).
  EXPECT_DOUBLE_EQ(result.too_far, std::erfc(std::sqrt(1.8)));
  EXPECT_DOUBLE_EQ(result.too_near, std::erf(std::sqrt(1.8)));
}

TEST(ChiSquare, KeepsATailThatOneMinusTheOtherWouldLose) {
  const ChiSquare result = chi_square(Counts{800, 200}, Probabilities{0.5, 0.5});
  EXPECT_EQ(result.too_near, 1);
  EXPECT_GT(result.too_far, 0);
  EXPECT_LT(result.too_far, 1e-70);
}

TEST(ChiSquare, PoolsNeighboursUntilEightyAreExpected) {
  const ChiSquare result = chi_square(Counts{40, 40, 40, 40, 40}, Probabilities{0.2, 0.2, 0.2, 0.2, 0.2});
  EXPECT_EQ(result.degrees, 1);  // 80 and, with the last one left over, 120
  EXPECT_EQ(result.statistic, 0);
}

TEST(ChiSquare, RefusesWhatIsNoHistogram) {
  EXPECT_THROW(chi_square(Counts{100}, Probabilities{0.5, 0.5}), std::invalid_argument);
  EXPECT_THROW(chi_square(Counts{}, Probabilities{}), std::invalid_argument);
  EXPECT_THROW(chi_square(Counts{0, 0}, Probabilities{0.5, 0.5}), std::invalid_argument);
  EXPECT_THROW(chi_square(Counts{100, 100}, Probabilities{0.5, 0.6}), std::invalid_argument);
  EXPECT_THROW(chi_square(Counts{100, 100}, Probabilities{1.5, -0.5}), std::invalid_argument);
  EXPECT_THROW(chi_square(Counts{100, 100}, Probabilities{1, 0}), std::invalid_argument);
  EXPECT_THROW(chi_square(Counts{10, 10}, Probabilities{0.5, 0.5}), TooFewDraws);
}

TEST(Judge, CertifiesTheExpectedCountsOnlyWithEnoughDraws) {
  const double alpha = 1e-8;
  const double beta = 0.01;
  const double distance = 0.1;
  const std::uint64_t enough = draws_to_tell_apart(4, distance, alpha, beta);
  // A likely statistic: three degrees of freedom, value near three.
  const ChiSquare likely{3, 3, 0.39, 0.61};
  EXPECT_EQ(judge(likely, enough, distance, alpha, beta), Verdict::certified);
  EXPECT_EQ(judge(likely, enough / 10, distance, alpha, beta), Verdict::undecided);
}

TEST(Judge, CallsBothTailsBiased) {
  EXPECT_EQ(judge({90, 3, 1e-18, 1}, 1'000'000, 0.1, 1e-8, 0.01), Verdict::biased);
  EXPECT_EQ(judge({1, 30, 1, 1e-11}, 1'000'000, 0.1, 1e-8, 0.01), Verdict::biased);
  EXPECT_EQ(judge({0, 1, 1, 0}, 1'000'000, 0.1, 1e-8, 0.01), Verdict::certified) << "a coin is often exactly even";
}

TEST(DrawsToTellApart, GrowWithTheInverseSquareOfTheDistance) {
  const std::uint64_t coarse = draws_to_tell_apart(64, 0.01, 1e-8, 0.01);
  const std::uint64_t fine = draws_to_tell_apart(64, 0.001, 1e-8, 0.01);
  EXPECT_LE(fine, 100 * coarse);  // both are rounded up, so the coarse one by less than a draw
  EXPECT_GT(fine, 100 * (coarse - 1));
}

// 1000 draws expect 100, 50, 50, 700, 60 and 40 of these cells.
TEST(ChiSquare, PoolsNeighboursUntilTheyExpectEighty) {
  const std::vector<double> p{0.1, 0.05, 0.05, 0.7, 0.06, 0.04};
  EXPECT_EQ(ends_of_groups(p, 1000), (std::vector<std::size_t>{1, 3, 4, 6}));
  EXPECT_EQ(ends_of_groups(p, 2000), (std::vector<std::size_t>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(ends_of_groups(p, 950), (std::vector<std::size_t>{1, 3, 4, 6}));  // 95 for the last two
  EXPECT_EQ(ends_of_groups(p, 700), (std::vector<std::size_t>{2, 6}));  // 105, then 35 + 490, and 70 left over
  EXPECT_TRUE(ends_of_groups(p, 70).empty());
}

}  // namespace
}  // namespace fairlight

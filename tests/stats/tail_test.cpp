#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <fairlight/stats/tail.h>

namespace fairlight {
namespace {

// The quantiles of a law with P(X > x) = x^-index, whose density falls like x^-(index + 1).
std::vector<double> power_law(double index, int n) {
  std::vector<double> draws;
  for (int i = 0; i < n; ++i) draws.push_back(std::pow((i + 0.5) / n, -1 / index));
  return draws;
}

TEST(LargestScores, FindTheExponentOfAPowerLaw) {
  for (double index : {1.5, 2.5, 6.0}) {
    LargestScores scores;
    scores.add(power_law(index, 100000));
    EXPECT_NEAR(scores.slope(), index + 1, 0.05 * index) << index;
  }
}

TEST(LargestScores, SeeNoTailInFewOrEqualDraws) {
  LargestScores few;
  few.add(power_law(1.5, 24));
  EXPECT_EQ(few.slope(), std::numeric_limits<double>::infinity());
  LargestScores equal;
  equal.add(std::vector<double>(1000, 3.0));
  EXPECT_EQ(equal.slope(), std::numeric_limits<double>::infinity());
}

TEST(LargestScores, DoNotDependOnTheOrderOfTheDraws) {
  std::vector<double> draws = power_law(2, 1000);
  LargestScores falling;
  falling.add(draws);
  LargestScores rising;
  rising.add(std::vector<double>(draws.rbegin(), draws.rend()));
  EXPECT_NEAR(falling.slope(), rising.slope(), 1e-12);
}

}  // namespace
}  // namespace fairlight

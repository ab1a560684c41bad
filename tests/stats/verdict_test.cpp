#include <gtest/gtest.h>

#include <fairlight/stats/verdict.h>

namespace fairlight {
namespace {

TEST(Verdict, BiasedIsWorseThanUndecidedIsWorseThanCertified) {
  EXPECT_EQ(worse(Verdict::certified, Verdict::certified), Verdict::certified);
  EXPECT_EQ(worse(Verdict::certified, Verdict::undecided), Verdict::undecided);
  EXPECT_EQ(worse(Verdict::biased, Verdict::undecided), Verdict::biased);
  EXPECT_EQ(worse(Verdict::certified, Verdict::biased), Verdict::biased);
}

TEST(Verdict, HasTheNamesOfTheContract) {
  EXPECT_STREQ(name(Verdict::certified), "certified");
  EXPECT_STREQ(name(Verdict::biased), "biased");
  EXPECT_STREQ(name(Verdict::undecided), "undecided");
  EXPECT_STREQ(name(Guarantee::deterministic), "deterministic");
  EXPECT_STREQ(name(Guarantee::exact), "exact");
  EXPECT_STREQ(name(Guarantee::exact_given_tail), "exact, given its tail");
  EXPECT_STREQ(name(Guarantee::asymptotic), "asymptotic");
}

}  // namespace
}  // namespace fairlight

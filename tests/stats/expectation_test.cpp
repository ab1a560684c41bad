#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <stdexcept>

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/stats/googletest.h>
#include <fairlight/stats/rapidcheck.h>

namespace fairlight {
namespace {

const auto uniform = [](Generator& generator) { return std::uniform_real_distribution<>()(generator); };

TEST(TrialAt, SharesTheBudgetAmongTheTestsAndTheirExpectations) {
  const Trial first = trial_at({"a", 10, 1, ""}, 0.01);
  const Trial second = trial_at({"a", 10, 2, ""}, 0.01);
  EXPECT_DOUBLE_EQ(first.alpha, 1e-7 * 6 / (M_PI * M_PI));
  EXPECT_DOUBLE_EQ(second.alpha, first.alpha / 4);
  EXPECT_NE(first.claim, second.claim);
  double sum = 0;
  for (std::uint64_t k = 1; k <= 100000; ++k) sum += trial_at({"a", 10, k, ""}, 0.01).alpha;
  EXPECT_LT(sum, 1e-7);
  EXPECT_GT(sum, 0.9999e-7);
}

TEST(TrialAt, RefusesAMarginThatIsNone) {
  for (double margin : {0.0, 1.0, -1.0}) EXPECT_THROW(trial_at({"a", 1, 1, ""}, margin), std::invalid_argument);
  EXPECT_THROW(trial_at({"a", 0, 1, ""}, 0.1), std::invalid_argument);
}

TEST(GeneratorFor, DependsOnTheSeedTheClaimAndThePurpose) {
  const Trial a{"a", 1, 0.1, 0.1, 0.1};
  const Trial b{"b", 1, 0.1, 0.1, 0.1};
  const Trial c{"a", 2, 0.1, 0.1, 0.1};
  EXPECT_EQ(generator_for(a)(), generator_for(a)());
  EXPECT_NE(generator_for(a)(), generator_for(b)());
  EXPECT_NE(generator_for(a)(), generator_for(c)());
  EXPECT_NE(generator_for(a)(), generator_for(a, "pilot")());
}

TEST(Expectation, OfAMeanIsMetOrSaysWhatIsWrong) {
  EXPECT_TRUE(expect_unbiased(googletest_site(), uniform, bounded(0.5, 0, 1), 0.02).met);
  EXPECT_TRUE(expect_unbiased(googletest_site(), uniform, 0.5, 0.02).met);
  const Expectation wrong = expect_unbiased(googletest_site(), uniform, bounded(0.6, 0, 1), 0.02);
  EXPECT_FALSE(wrong.met);
  for (const char* part : {"biased: the mean is 0.6", "exact", "level", "####",
                           "again: FAIRLIGHT_SEED=", "--gtest_filter=Expectation.OfAMeanIsMetOrSaysWhatIsWrong"}) {
    EXPECT_NE(wrong.message.find(part), std::string::npos) << part << " is not in\n" << wrong.message;
  }
}

TEST(Expectation, OfOneSideIsMetOrNot) {
  EXPECT_TRUE(expect_at_most(googletest_site(), uniform, bounded(0.5, 0, 1), 0.02).met);
  EXPECT_TRUE(expect_at_least(googletest_site(), uniform, bounded(0.5, 0, 1), 0.02).met);
  EXPECT_TRUE(expect_at_most(googletest_site(), uniform, nonnegative(0.7), 0.02).met);
  const Expectation high = expect_at_most(googletest_site(), uniform, nonnegative(0.4), 0.02);
  EXPECT_TRUE(high.message.starts_with("biased")) << high.message;
  EXPECT_NE(high.message.find(", exact"), std::string::npos) << high.message;
}

TEST(Expectation, OfAVarianceIsMetOrNot) {
  EXPECT_TRUE(expect_variance_at_most(googletest_site(), in_range(uniform, 0, 1), 1. / 12, 0.1).met);
  EXPECT_TRUE(expect_variance_at_most(googletest_site(), uniform, 0.1, 0.1).met);
  EXPECT_FALSE(expect_variance_at_most(googletest_site(), uniform, 0.07, 0.1).met);
  EXPECT_THROW(expect_variance_at_most(googletest_site(), uniform, 0, 0.1), std::invalid_argument);
  EXPECT_THROW(expect_variance_at_most(googletest_site(), uniform, -1, 0.1), std::invalid_argument);
}

TEST(Expectation, OfAMeanOfFiniteVarianceIsMetOrNot) {
  const auto pareto = [](Generator& generator) { return 0.6 * std::pow(1 - uniform(generator), -0.4); };
  EXPECT_TRUE(expect_unbiased(googletest_site(), pareto, finite_variance(1, 0.8), 0.05).met);
  EXPECT_FALSE(expect_unbiased(googletest_site(), pareto, finite_variance(1.1, 0.8), 0.05).met);
}

TEST(Expectation, SaysWhatItShowedOnRequest) {
  setenv("FAIRLIGHT_VERBOSE", "1", 1);
  ::testing::internal::CaptureStdout();
  EXPECT_UNBIASED(uniform, bounded(0.5, 0, 1), 0.1);
  const std::string shown = ::testing::internal::GetCapturedStdout();
  unsetenv("FAIRLIGHT_VERBOSE");
  for (const char* part : {"certified: the mean is 0.5", "margin 1.0e-01", "draws", "exact"})
    EXPECT_NE(shown.find(part), std::string::npos) << part << " is not in\n" << shown;
}

TEST(Expectation, RefusesWhatCannotBeTestedInOneSentence) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (double none : {0.0, 1.0, -1.0, nan, inf})
    EXPECT_THROW(expect_unbiased(googletest_site(), uniform, 0.5, none), std::invalid_argument) << none;
  for (double none : {nan, inf})
    EXPECT_THROW(expect_unbiased(googletest_site(), uniform, none, absolute(0.1)), std::invalid_argument) << none;
  EXPECT_THROW(bounded(0.5, 1, 0), std::invalid_argument);
  EXPECT_THROW(bounded(0.5, nan, 1), std::invalid_argument);
  EXPECT_THROW(expect_unbiased(googletest_site(), uniform, bounded(0.5, 0.6, 1), 0.1), std::invalid_argument);
  for (double none : {0.0, -1.0, nan, inf})
    EXPECT_THROW(expect_unbiased(googletest_site(), uniform, finite_variance(0.5, none), 0.1),
                 std::invalid_argument);
}

TEST(Expectation, NamesTheDrawThatIsNone) {
  const auto broken = [](Generator&) { return std::nan(""); };
  const Expectation found = expect_unbiased(googletest_site(), broken, bounded(0.5, 0, 1), 0.02);
  EXPECT_FALSE(found.met);
  EXPECT_NE(found.message.find("draw 0 is nan"), std::string::npos) << found.message;
}

TEST(Expectation, OfALawIsMetOrSaysWhatIsWrong) {
  const auto flat = [](double) { return 1.0; };
  EXPECT_TRUE(expect_follows(googletest_site(), uniform, flat, IntervalDomain{0, 1}, 0.05).met);
  const auto tenth_too_much = [](double) { return 1.1; };
  const Expectation wrong = expect_follows(googletest_site(), uniform, tenth_too_much, IntervalDomain{0, 1}, 0.05);
  EXPECT_FALSE(wrong.met);
  EXPECT_NE(wrong.message.find("integrates to 1.1"), std::string::npos) << wrong.message;
}

TEST(Expectation, OfAgreementIsMetOrNot) {
  const auto cubed = [](Generator& generator) { return 2 * std::pow(uniform(generator), 3); };
  EXPECT_TRUE(expect_agree(googletest_site(), cubed, uniform, 0.05).met);
  const auto squared = [](Generator& generator) { return 2 * std::pow(uniform(generator), 2); };
  EXPECT_FALSE(expect_agree(googletest_site(), squared, uniform, 0.05).met);
  EXPECT_TRUE(expect_agree(googletest_site(), in_range(cubed, 0, 2), in_range(uniform, 0, 1), 0.05).met);
  EXPECT_FALSE(expect_agree(googletest_site(), in_range(squared, 0, 2), in_range(uniform, 0, 1), 0.05).met);
}

TEST(ExpectationMacros, FailTheTest) {
  EXPECT_NONFATAL_FAILURE(EXPECT_UNBIASED(uniform, bounded(0.6, 0, 1), 0.02), "biased: the mean is 0.6");
  EXPECT_NONFATAL_FAILURE(EXPECT_UNBIASED(uniform, 0.6, 0.02), "undecided: the mean is 0.6");
  EXPECT_NONFATAL_FAILURE(EXPECT_AT_MOST(uniform, bounded(0.4, 0, 1), 0.02), "biased: the mean is at most 0.4");
  EXPECT_NONFATAL_FAILURE(EXPECT_AT_LEAST(uniform, bounded(0.6, 0, 1), 0.02), "biased: the mean is at least 0.6");
  EXPECT_NONFATAL_FAILURE(EXPECT_VARIANCE_AT_MOST(in_range(uniform, 0, 1), 0.05, 0.02),
                          "biased: the variance is at most 0.05");
  const auto squared = [](Generator& generator) { return std::pow(uniform(generator), 2); };
  EXPECT_NONFATAL_FAILURE(EXPECT_AGREE(in_range(uniform, 0, 1), in_range(squared, 0, 1), 0.02),
                          "biased: the two means agree");
  EXPECT_NONFATAL_FAILURE(EXPECT_FOLLOWS(uniform, ([](double x) { return 2 * x; }), IntervalDomain{0, 1}, 0.05),
                          "biased: the draws follow the density");
}

TEST(ExpectationMacros, FailAProperty) {
  EXPECT_THROW(RC_EXPECT_UNBIASED(uniform, bounded(0.6, 0, 1), 0.02), rc::detail::CaseResult);
  EXPECT_NO_THROW(RC_EXPECT_UNBIASED(uniform, bounded(0.5, 0, 1), 0.02));
}

}  // namespace
}  // namespace fairlight

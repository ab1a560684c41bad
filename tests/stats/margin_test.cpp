#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include <fairlight/stats/googletest.h>
#include <fairlight/stats/margin.h>

namespace fairlight {
namespace {

const auto normal = [](Generator& g) { return std::normal_distribution<>()(g); };
const auto uniform = [](Generator& g) { return std::uniform_real_distribution<>(-1, 1)(g); };

std::string refusal(const std::function<void()>& expectation) {
  try {
    expectation();
  } catch (const std::invalid_argument& refused) {
    return refused.what();
  }
  return "not refused";
}

TEST(AMargin, IsAShareOfTheReferenceOrOfAScaleOrAbsolute) {
  EXPECT_EQ(Margin(0.1).scale(-3), 3);
  EXPECT_EQ(Margin(0.1, 2).scale(-3), 2);
  const Margin fifth = absolute(0.2);
  EXPECT_EQ(fifth.share() * fifth.scale(0), 0.2);
  EXPECT_EQ(fifth.unit(fifth.scale(0)), 0.4);
  for (double none : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_THROW(absolute(none), std::invalid_argument) << none;
    EXPECT_THROW(Margin(0.1, none), std::invalid_argument) << none;
  }
}

TEST(MeansOfZero, AreTestedToAnAbsoluteMargin) {
  for (const Margin& margin : {absolute(0.05), Margin(0.01, 5)}) {
    EXPECT_UNBIASED(normal, 0.0, margin);
    EXPECT_UNBIASED(uniform, bounded(0, -1, 1), margin);
    EXPECT_UNBIASED(normal, finite_variance(0, 1), margin);
    EXPECT_AT_MOST(uniform, bounded(0, -1, 1), margin);
    EXPECT_AT_LEAST(normal, 0.0, margin);
    EXPECT_AGREE(normal, normal, margin);
    EXPECT_AGREE(in_range(uniform, -1, 1), in_range(uniform, -1, 1), margin);
  }
}

TEST(MeansOfZero, AreRefusedWithWhatToGive) {
  for (const std::string& why :
       {refusal([] { EXPECT_UNBIASED(normal, 0.0, 0.01); }),
        refusal([] { EXPECT_UNBIASED(uniform, bounded(0, -1, 1), 0.01); }),
        refusal([] { EXPECT_UNBIASED(normal, finite_variance(0, 1), 0.01); }),
        refusal([] { EXPECT_AT_MOST(normal, 0.0, 0.01); }), refusal([] { EXPECT_AGREE(normal, normal, 0.05); }),
        refusal([] { EXPECT_AGREE(in_range(uniform, -1, 1), in_range(uniform, -1, 1), 0.05); })})
    EXPECT_NE(why.find("fairlight::absolute(0.01)"), std::string::npos) << why;
}

TEST(AnAbsoluteMargin, ShowsTheBiasInTheUnitOfTheDraws) {
  const auto shifted = [](Generator& g) { return 100 + uniform(g); };
  const Expectation found = expect_unbiased(googletest_site(), shifted, bounded(102, 99, 103), absolute(0.5));
  EXPECT_TRUE(found.message.starts_with("biased"));
  EXPECT_NE(found.message.find("margin 5.0e-01, in the unit of the draws"), std::string::npos) << found.message;
}

}  // namespace
}  // namespace fairlight

#include <limits>

#include <gtest/gtest.h>
#include <support/run_seed.h>

#include <fairlight/validation/checks/variances.h>

namespace fairlight {
namespace {

const Trial trial{"variances_test", testing::run_seed(), 1e-6, 0.01, 0.1};

// 0 or 1, of variance 1/4.
VarianceArm coin(int n = 1) {
  return independent_draws(
      "a coin", [](auto& source) { return source.next() < 0.5 ? 0.0 : 1.0; }, 0, 1, n);
}

TEST(IndependentDraws, AverageThoseOfOneSource) {
  const StreamKey key(1, "mean");
  const VarianceArm three = independent_draws(
      "numbers", [](auto& source) { return source.next(); }, 0, 1, 3);
  PhiloxStream<double> source(key, 0, 5);
  const double first = source.next();
  const double second = source.next();
  EXPECT_EQ(three.draw(key, 5), (first + second + source.next()) / 3);
  EXPECT_NE(three.draw(key, 5), three.draw(key, 6));
}

TEST(CheckVariances, CertifiesTheRatioAndFindsALargerOne) {
  EXPECT_EQ(check_variances(trial, 0.25, coin(4), coin()).verdict, Verdict::certified);
  EXPECT_EQ(check_variances(trial, 0.2, coin(4), coin()).verdict, Verdict::biased);
  EXPECT_EQ(check_variances(trial, 1, coin(), coin()).verdict, Verdict::certified);
}

TEST(CheckVariances, SaysTheRatioAndTheMostThatItIs) {
  const Finding finding = check_variances(trial, 0.5, coin(2), coin());
  EXPECT_TRUE(finding.note.starts_with("variance ratio 0.")) << finding.note;
  EXPECT_NE(finding.note.find(", at most 0."), std::string::npos) << finding.note;
  EXPECT_EQ(finding.interval.lo, -std::numeric_limits<double>::infinity());
  EXPECT_GT(0.5 * (1 + finding.interval.hi), 0.5);
}

TEST(CheckVariances, SaysBetweenWhatTheRatioIsWhereItIsTooLarge) {
  const Finding finding = check_variances(trial, 0.2, coin(4), coin());
  ASSERT_EQ(finding.verdict, Verdict::biased);
  EXPECT_GT(finding.interval.lo, 0);
  EXPECT_NE(finding.note.find(", in [0.2"), std::string::npos) << finding.note;
}

TEST(CheckVariances, NamesADrawOutOfItsRange) {
  const VarianceArm wrong{"wrong", [](const StreamKey&, std::uint64_t) { return 2.0; }, 0, 1};
  const Finding finding = check_variances(trial, 1, wrong, coin());
  EXPECT_EQ(finding.verdict, Verdict::biased);
  EXPECT_NE(finding.note.find("is 2 "), std::string::npos) << finding.note;
}

}  // namespace
}  // namespace fairlight

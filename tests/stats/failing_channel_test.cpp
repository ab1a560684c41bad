#include <random>

#include <gtest/gtest.h>
#include <support/run_seed.h>

#include <fairlight/stats/mean_test.h>

namespace fairlight {
namespace {

Finding of(Verdict verdict, double bias, Interval interval) {
  return {verdict, Guarantee::exact, 0.1, bias, interval, 10};
}

TEST(WorstOf, IsAChannelOfTheWorstVerdict) {
  const Finding failed = of(Verdict::biased, 0.01, {0.005, 0.015}), noisy = of(Verdict::undecided, 0.2, {0.1, 0.3});
  for (const auto& channels : {std::vector{failed, noisy}, std::vector{noisy, failed}}) {
    EXPECT_EQ(worst_of(channels).bias, 0.01);
    EXPECT_EQ(worst_of(channels).interval.lo, 0.005);
    EXPECT_EQ(worst_of(channels).verdict, Verdict::biased);
  }
}

TEST(WorstOf, PrefersAnIntervalBeyondZeroThenALargerBias) {
  const Finding beyond = of(Verdict::undecided, 0.01, {0.005, 0.015}), noisy = of(Verdict::undecided, 0.2, {-1, 1}),
                calm = of(Verdict::undecided, 0.1, {-1, 1});
  EXPECT_EQ(worst_of({noisy, beyond}).bias, 0.01);
  EXPECT_EQ(worst_of({calm, noisy}).bias, 0.2);
}

// Channel 2 is steady and off by 0.08; the others are right, but rarely not 0, so theirs is the largest
// bias.
TEST(TestMeans, ShowsAndNamesTheChannelThatFailed) {
  std::mt19937_64 numbers(testing::run_seed());
  std::uniform_real_distribution<double> unit(0, 1), narrow(1.07, 1.09);
  const Finding finding = test_means({"channels", 1, 1e-6, 0.01, 0.05}, {{1, 0, 100}, {1, 0, 100}, {1, 0, 2}},
                                     [&](std::uint64_t, std::vector<std::vector<double>>& channels) {
                                       for (std::size_t c = 0; c < channels.size(); ++c) {
                                         for (double& x : channels[c])
                                           x = c == 2 ? narrow(numbers) : unit(numbers) < 0.01 ? 100 : 0;
                                       }
                                     });
  ASSERT_EQ(finding.verdict, Verdict::biased);
  EXPECT_NEAR(finding.bias, 0.08, 0.01) << "draws of the channel are within 0.01 of it";
  EXPECT_GT(finding.interval.lo, 0);
  EXPECT_EQ(finding.note, "channel 2, of 0 to 2");
}

}  // namespace
}  // namespace fairlight

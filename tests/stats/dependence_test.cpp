#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <support/run_seed.h>

#include <fairlight/stats/dependence.h>
#include <fairlight/stats/googletest.h>

namespace fairlight {
namespace {

std::string warning_of(const std::vector<double>& draws) {
  LagOne in_blocks;
  for (std::size_t i = 0; i < draws.size(); i += 50)
    in_blocks.add(std::span(draws).subspan(i, std::min<std::size_t>(50, draws.size() - i)));
  return in_blocks.warning();
}

TEST(LagOne, IsTheCorrelationOfEachDrawWithTheNext) {
  LagOne alternating;
  alternating.add(std::vector<double>{1, -1, 1, -1, 1, -1, 1, -1});
  EXPECT_EQ(alternating.correlation(), -7. / 8);
}

TEST(LagOne, WarnsOfChainsAndOfPeriods) {
  std::mt19937_64 generator(testing::run_seed());
  std::uniform_real_distribution<> uniform;
  std::vector<double> chain(1000), period(1000);
  double x = 0;
  for (double& draw : chain) draw = x = 0.8 * x + uniform(generator);
  for (std::size_t i = 0; i < period.size(); ++i) period[i] = static_cast<double>(i % 8) + uniform(generator);
  EXPECT_NE(warning_of(chain).find("depend on each other"), std::string::npos);
  EXPECT_NE(warning_of(period).find("depend on each other"), std::string::npos);
}

// Two spikes side by side are a correlation of a half, and chance.
TEST(LagOne, DoesNotWarnOfRareDrawsSideBySide) {
  std::vector<double> spikes(1000);
  spikes[500] = spikes[501] = 1;
  EXPECT_EQ(warning_of(spikes), "");
  EXPECT_EQ(warning_of(std::vector<double>(1000, 0.1)), "");
  EXPECT_EQ(warning_of({}), "");
}

TEST(Dependence, IsAWarningInAMessage) {
  double x = 0.5;
  const auto chain = [&](Generator& g) { return x = 0.9 * x + 0.1 * std::uniform_real_distribution<>()(g); };
  ::testing::internal::CaptureStdout();
  expect_unbiased(googletest_site(), chain, bounded(0.5, 0, 1), 0.02);
  expect_unbiased(googletest_site(), chain, 0.5, 0.1);
  expect_agree(googletest_site(), chain, chain, 0.1);
  const std::string shown = ::testing::internal::GetCapturedStdout();
  const Expectation failed = expect_unbiased(googletest_site(), chain, bounded(0.7, 0, 1), 0.02);
  EXPECT_NE((shown + failed.message).find("warning: the draws depend on each other"), std::string::npos);
}

}  // namespace
}  // namespace fairlight

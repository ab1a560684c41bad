#include <chrono>
#include <cstdlib>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include <fairlight/stats/googletest.h>

namespace fairlight {
namespace {

const auto uniform = [](Generator& g) { return std::uniform_real_distribution<>()(g); };

TEST(Limits, ComeFromTheArgumentOrTheEnvironmentOrTheirDefault) {
  EXPECT_EQ(resolved({}).draws, 1e10);
  EXPECT_EQ(resolved({}).seconds, 60);
  setenv("FAIRLIGHT_DRAWS", "1e6", 1);
  setenv("FAIRLIGHT_SECONDS", "0.5", 1);
  EXPECT_EQ(resolved({}).draws, 1e6);
  EXPECT_EQ(resolved({}).seconds, 0.5);
  EXPECT_EQ(resolved({.draws = 7}).draws, 7);
  for (const char* none : {"", "many", "-1", "0", "nan", "1e6 draws"}) {
    setenv("FAIRLIGHT_DRAWS", none, 1);
    EXPECT_THROW(resolved({}), std::invalid_argument) << none;
  }
  unsetenv("FAIRLIGHT_DRAWS");
  unsetenv("FAIRLIGHT_SECONDS");
  EXPECT_THROW(resolved({.draws = -1}), std::invalid_argument);
  EXPECT_THROW(resolved({.seconds = std::nan("")}), std::invalid_argument);
}

TEST(AMeter, CountsDrawsUpToItsLimit) {
  Meter meter({1000, 1e6});
  for (int i = 0; i < 1000; ++i) meter.draw();
  EXPECT_THROW(meter.draw(), NoMoreDraws);
}

// Every door, with a margin that would take for ever.
TEST(ACap, EndsAnExpectationUndecidedWithWhatItReachedAndWhatItWouldTake) {
  const Limits limits{.draws = 1e5};
  const auto flat = [](double) { return 1.0; };
  for (const Expectation& found :
       {expect_unbiased(googletest_site(), uniform, bounded(0.5, 0, 1), 1e-6, limits),
        expect_unbiased(googletest_site(), uniform, 0.5, 1e-5, limits),
        expect_unbiased(googletest_site(), uniform, finite_variance(0.5, 0.1), 1e-5, limits),
        expect_at_most(googletest_site(), uniform, nonnegative(0.5), 1e-5, limits),
        expect_variance_at_most(googletest_site(), in_range(uniform, 0, 1), 1. / 12, 1e-5, limits),
        expect_agree(googletest_site(), uniform, uniform, 1e-5, limits),
        expect_agree(googletest_site(), in_range(uniform, 0, 1), in_range(uniform, 0, 1), 1e-5, limits)}) {
    EXPECT_TRUE(found.message.starts_with("undecided")) << found.message;
    for (const char* part : {"the cap of 100000 draws came first", "a verdict needs", "allow more"})
      EXPECT_NE(found.message.find(part), std::string::npos) << part << " is not in\n" << found.message;
  }
  const Expectation law = expect_follows(googletest_site(), uniform, flat, IntervalDomain{0, 1}, 1e-5, limits);
  EXPECT_NE(law.message.find("the cap of 100000 draws"), std::string::npos) << law.message;
}

TEST(ACap, ShowsAnIntervalNearThatOfTheDraws) {
  Trial trial{"capped", 1, 1e-6, 0.01, 1e-7};
  Generator generator = generator_for(trial);
  Meter meter({1e6, 1e6});
  const Finding finding = test_mean(trial, {0.5, 0, 1}, [&] {
    meter.draw();
    return uniform(generator);
  });
  // 0.577 / 1000 is the standard error.
  EXPECT_GT(finding.interval.lo, -12 * 0.577e-3);
  EXPECT_LT(finding.interval.hi, 12 * 0.577e-3);
  EXPECT_LT(finding.interval.lo, finding.bias);
  EXPECT_GT(finding.interval.hi, finding.bias);
}

TEST(ACapOfSeconds, EndsSlowDraws) {
  const auto slow = [](Generator& g) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(20);
    while (std::chrono::steady_clock::now() < end) continue;
    return uniform(g);
  };
  const Expectation found = expect_unbiased(googletest_site(), slow, 0.5, 0.01, Limits{.seconds = 0.2});
  EXPECT_NE(found.message.find("the cap of 0.2 s came first"), std::string::npos) << found.message;
}

}  // namespace
}  // namespace fairlight

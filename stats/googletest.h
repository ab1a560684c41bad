#pragma once

#include <gtest/gtest.h>

#include <fairlight/stats/domains.h>
#include <fairlight/stats/expectation.h>

/// Expectations for GoogleTest. This header needs GoogleTest; fairlight::stats itself does not.
///   EXPECT_UNBIASED(estimator, reference, margin)  estimator(generator) has this mean, a number
///                                                  or bounded(mean, lower, upper), an exact test
///   EXPECT_FOLLOWS(sampler, density, domain)       sampler(generator) follows density(point), or a
///                                                  table of probabilities
///   EXPECT_SAME_LAW(a, b, domain)                  two samplers follow the same law
///   EXPECT_AGREE(a, b, margin)                     two estimators have the same mean
/// The shares of the budget come from GoogleTest's list of all tests, so --gtest_filter changes
/// none. Set FAIRLIGHT_SEED to the seed that a failure prints to replay it.
namespace fairlight {

/// The site of the next expectation in the running test. Throws std::logic_error outside a test.
inline Site googletest_site() {
  const auto* program = ::testing::UnitTest::GetInstance();
  const auto* test = program->current_test_info();
  if (test == nullptr) throw std::logic_error("an expectation must stand in a test (it has no share elsewhere)");
  static const ::testing::TestInfo* last = nullptr;
  static std::uint64_t ordinal = 0;
  ordinal = test == last ? ordinal + 1 : 1;
  last = test;
  const std::string name = std::string(test->test_suite_name()) + "." + test->name();
  return {name, static_cast<std::uint64_t>(program->total_test_count()), ordinal, "--gtest_filter=" + name};
}

inline ::testing::AssertionResult assertion(const Expectation& expectation) {
  return (expectation.met ? ::testing::AssertionSuccess() : ::testing::AssertionFailure()) << expectation.message;
}

}  // namespace fairlight

#define EXPECT_UNBIASED(estimator, reference, margin) \
  EXPECT_TRUE(fairlight::assertion(                   \
      fairlight::expect_unbiased(fairlight::googletest_site(), estimator, reference, margin)))
#define EXPECT_FOLLOWS(sampler, density, ...) \
  EXPECT_TRUE(fairlight::assertion(           \
      fairlight::expect_follows(fairlight::googletest_site(), sampler, density, __VA_ARGS__)))
#define EXPECT_SAME_LAW(a, b, ...) \
  EXPECT_TRUE(                     \
      fairlight::assertion(fairlight::expect_same_law(fairlight::googletest_site(), a, b, __VA_ARGS__)))
#define EXPECT_AGREE(a, b, margin) \
  EXPECT_TRUE(fairlight::assertion(fairlight::expect_agree(fairlight::googletest_site(), a, b, margin)))

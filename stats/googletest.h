#pragma once

#include <algorithm>
#include <mutex>

#include <gtest/gtest.h>

#include <fairlight/stats/domains.h>
#include <fairlight/stats/expectation.h>

/// Expectations for GoogleTest. This header needs GoogleTest; fairlight::stats itself does not.
///   EXPECT_UNBIASED(estimator, reference, margin)  estimator(generator) has this mean, a number
///                                                  or bounded(mean, lower, upper), an exact test
///   EXPECT_AT_MOST, EXPECT_AT_LEAST                the same, of one side
///   EXPECT_AGREE(a, b, margin)                     two estimators have the same mean
///   EXPECT_VARIANCE_AT_MOST(in_range(estimator, lower, upper), variance, margin)
///   EXPECT_INTERVALS(estimator, reference, level)  its intervals, or standard errors, cover as
///                                                  they say
///   EXPECT_FOLLOWS(sampler, density, domain)       sampler(generator) follows density(point), or a
///                                                  table of probabilities
///   EXPECT_SAME_LAW(a, b, domain)                  two samplers follow the same law
/// A margin is a share of the reference, or absolute(0.01). A last argument limits draws and
/// seconds, as in Limits{.seconds = 10}. The shares of the budget come from GoogleTest's list of
/// all tests, so --gtest_filter changes none. Set FAIRLIGHT_SEED to the seed that a failure prints
/// to replay it. See docs/validation.md, "For your own estimators".
namespace fairlight {

namespace detail {

/// Counts the runs of the program's tests, and the expectations in the running test.
class GoogletestCounter : public ::testing::EmptyTestEventListener {
 public:
  /// The program's counter, listening from the first expectation on.
  static GoogletestCounter& instance() {
    static GoogletestCounter* const counter = [] {
      auto* made = new GoogletestCounter;  // GoogleTest deletes its listeners
      ::testing::UnitTest::GetInstance()->listeners().Append(made);
      return made;
    }();
    return *counter;
  }

  void OnTestIterationStart(const ::testing::UnitTest&, int) override { ++repetition_; }
  void OnTestStart(const ::testing::TestInfo&) override { ordinal_ = 0; }

  /// The next expectation: the number of the run, 0 for the first, and its own in its test.
  std::pair<std::uint64_t, std::uint64_t> next() {
    const std::lock_guard lock(mutex_);
    return {repetition_, ++ordinal_};
  }

 private:
  std::mutex mutex_;
  std::uint64_t repetition_ = 0, ordinal_ = 0;
};

/// The flags that run one test alone. In a name, what a filter would take for its own syntax becomes
/// a wildcard.
inline std::string googletest_flags(std::string name) {
  const bool disabled = name.starts_with("DISABLED_") || name.find(".DISABLED_") != std::string::npos ||
                        name.find("/DISABLED_") != std::string::npos;
  std::ranges::replace_if(
      name, [](char c) { return c == ':' || c == '-' || c == '*'; }, '?');
  return "--gtest_filter=" + name + (disabled ? " --gtest_also_run_disabled_tests" : "");
}

}  // namespace detail

/// The site of the next expectation in the running test. Throws std::logic_error outside a test.
inline Site googletest_site() {
  const auto* program = ::testing::UnitTest::GetInstance();
  const auto* test = program->current_test_info();
  if (test == nullptr) throw std::logic_error("an expectation must stand in a test (it has no share elsewhere)");
  const auto [repetition, ordinal] = detail::GoogletestCounter::instance().next();
  const std::string name = std::string(test->test_suite_name()) + "." + test->name();
  return {name, static_cast<std::uint64_t>(program->total_test_count()), ordinal, detail::googletest_flags(name),
          repetition};
}

inline ::testing::AssertionResult assertion(const Expectation& expectation) {
  return (expectation.met ? ::testing::AssertionSuccess() : ::testing::AssertionFailure()) << expectation.message;
}

}  // namespace fairlight

#define EXPECT_UNBIASED(...) \
  EXPECT_TRUE(fairlight::assertion(fairlight::expect_unbiased(fairlight::googletest_site(), __VA_ARGS__)))
#define EXPECT_AT_MOST(...) \
  EXPECT_TRUE(fairlight::assertion(fairlight::expect_at_most(fairlight::googletest_site(), __VA_ARGS__)))
#define EXPECT_AT_LEAST(...) \
  EXPECT_TRUE(fairlight::assertion(fairlight::expect_at_least(fairlight::googletest_site(), __VA_ARGS__)))
#define EXPECT_VARIANCE_AT_MOST(...) \
  EXPECT_TRUE(fairlight::assertion(fairlight::expect_variance_at_most(fairlight::googletest_site(), __VA_ARGS__)))
#define EXPECT_INTERVALS(...) \
  EXPECT_TRUE(fairlight::assertion(fairlight::expect_intervals(fairlight::googletest_site(), __VA_ARGS__)))
#define EXPECT_FOLLOWS(...) \
  EXPECT_TRUE(fairlight::assertion(fairlight::expect_follows(fairlight::googletest_site(), __VA_ARGS__)))
#define EXPECT_SAME_LAW(...) \
  EXPECT_TRUE(fairlight::assertion(fairlight::expect_same_law(fairlight::googletest_site(), __VA_ARGS__)))
#define EXPECT_AGREE(...) \
  EXPECT_TRUE(fairlight::assertion(fairlight::expect_agree(fairlight::googletest_site(), __VA_ARGS__)))

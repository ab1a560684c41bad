#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <fairlight/stats/googletest.h>

/// Expectations inside rapidcheck properties that run under GoogleTest (RC_GTEST_PROP): the same three, which make
/// the property fail, and shrink, in place of the test. Every case of a property is an expectation of its test,
/// with a share that falls like 1/k^2, so any number of cases stays within the budget. Replaying takes both tokens: FAIRLIGHT_SEED, and the RC_PARAMS that
/// rapidcheck prints.
namespace fairlight {

inline void rapidcheck_fail_unless(const Expectation& expectation) {
  if (!expectation.met) RC_FAIL(expectation.message);
}

}  // namespace fairlight

#define RC_EXPECT_UNBIASED(estimator, reference, margin) \
  fairlight::rapidcheck_fail_unless(                     \
      fairlight::expect_unbiased(fairlight::googletest_site(), estimator, reference, margin))
#define RC_EXPECT_FOLLOWS(sampler, density, ...) \
  fairlight::rapidcheck_fail_unless(             \
      fairlight::expect_follows(fairlight::googletest_site(), sampler, density, __VA_ARGS__))
#define RC_EXPECT_AGREE(a, b, margin) \
  fairlight::rapidcheck_fail_unless(fairlight::expect_agree(fairlight::googletest_site(), a, b, margin))

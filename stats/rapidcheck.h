#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <fairlight/stats/googletest.h>

/// The same expectations for rapidcheck properties under GoogleTest (RC_GTEST_PROP). One that is
/// not met fails the property, and the case shrinks. Every case of a property is an expectation of
/// its test. The k-th has a share that falls like 1/k^2, so any number of cases stays within the
/// budget. To replay, set FAIRLIGHT_SEED and the seed=... of the RC_PARAMS that rapidcheck prints;
/// its reproduce=... would begin to count the cases at the wrong one.
namespace fairlight {

inline void rapidcheck_fail_unless(const Expectation& expectation) {
  if (!expectation.met) RC_FAIL(expectation.message);
}

}  // namespace fairlight

#define RC_EXPECT_UNBIASED(...) \
  fairlight::rapidcheck_fail_unless(fairlight::expect_unbiased(fairlight::googletest_site(), __VA_ARGS__))
#define RC_EXPECT_AT_MOST(...) \
  fairlight::rapidcheck_fail_unless(fairlight::expect_at_most(fairlight::googletest_site(), __VA_ARGS__))
#define RC_EXPECT_AT_LEAST(...) \
  fairlight::rapidcheck_fail_unless(fairlight::expect_at_least(fairlight::googletest_site(), __VA_ARGS__))
#define RC_EXPECT_VARIANCE_AT_MOST(...) \
  fairlight::rapidcheck_fail_unless(fairlight::expect_variance_at_most(fairlight::googletest_site(), __VA_ARGS__))
#define RC_EXPECT_INTERVALS(...) \
  fairlight::rapidcheck_fail_unless(fairlight::expect_intervals(fairlight::googletest_site(), __VA_ARGS__))
#define RC_EXPECT_FOLLOWS(...) \
  fairlight::rapidcheck_fail_unless(fairlight::expect_follows(fairlight::googletest_site(), __VA_ARGS__))
#define RC_EXPECT_AGREE(...) \
  fairlight::rapidcheck_fail_unless(fairlight::expect_agree(fairlight::googletest_site(), __VA_ARGS__))

#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <fairlight/stats/googletest.h>

/// The same three expectations for rapidcheck properties under GoogleTest (RC_GTEST_PROP). One that
/// is not met fails the property, and the case shrinks. Every case of a property is an expectation
/// of its test. The k-th has a share that falls like 1/k^2, so any number of cases stays within the
/// budget. To replay, set both FAIRLIGHT_SEED and the RC_PARAMS that rapidcheck prints.
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

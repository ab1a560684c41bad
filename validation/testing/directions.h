#pragma once

#include <fairlight/stats/googletest.h>
#include <fairlight/validation/checks/direction_expectations.h>

/// Expectations for anybody's samplers of directions, for GoogleTest, through an adapter of a few
/// lines (validation/checks/direction_expectations.h says which functions it has):
///   EXPECT_DIRECTION_SAMPLER(sampler)   draws follow the pdf, which integrates to 1
///   EXPECT_LIGHT(light, from)           the same of directions to a light from a point; a ray in a
///                                       sampled direction meets the light at the sample's distance
///   EXPECT_PHASE_FUNCTION(phase)        the same from three directions; reciprocity
/// Each takes DirectionTerms as a last argument.
#define EXPECT_DIRECTION_SAMPLER(sampler, ...)                   \
  EXPECT_TRUE(fairlight::assertion(fairlight::expect_directions( \
      fairlight::googletest_site(), fairlight::directions_of(sampler) __VA_OPT__(, ) __VA_ARGS__)))
#define EXPECT_LIGHT(light, from, ...)                                                             \
  EXPECT_TRUE(fairlight::assertion(                                                                \
      fairlight::expect_light(fairlight::googletest_site(), fairlight::directions_to(light, from), \
                              fairlight::distances_to(light, from) __VA_OPT__(, ) __VA_ARGS__)))
#define EXPECT_PHASE_FUNCTION(phase, ...)                            \
  EXPECT_TRUE(fairlight::assertion(fairlight::expect_phase_function( \
      fairlight::googletest_site(), fairlight::phase_function_of(phase) __VA_OPT__(, ) __VA_ARGS__)))

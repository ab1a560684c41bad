#pragma once

#include <fairlight/stats/googletest.h>
#include <fairlight/validation/checks/bsdf_expectation.h>

/// EXPECT_BSDF(bsdf) or EXPECT_BSDF(bsdf, terms), for GoogleTest: the three functions of anybody's
/// BSDF fit together (see check_bsdf). `bsdf` is an adapter of a dozen lines:
///   static constexpr std::size_t dimensions = 2;   // the numbers that sample takes
///   std::optional<BsdfSample> sample(const Vec3<double>& out, const std::array<double, 2>& u) const;
///   Rgb<double> eval(const Vec3<double>& out, const Vec3<double>& in) const;  // without the cosine
///   double pdf(const Vec3<double>& out, const Vec3<double>& in) const;        // [1/sr]
#define EXPECT_BSDF(bsdf, ...)                                                          \
  EXPECT_TRUE(fairlight::assertion(fairlight::expect_bsdf(                              \
      fairlight::googletest_site(), fairlight::under_test(bsdf) __VA_OPT__(, ) __VA_ARGS__)))

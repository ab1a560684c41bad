#pragma once

#include <algorithm>
#include <array>

#include <fairlight/stats/expectation.h>
#include <fairlight/validation/checks/bsdf_checks.h>

namespace fairlight {

/// The checks' view of an adapter of a BSDF (see validation/testing/bsdf.h), which must outlive it.
template <class Adapter>
BsdfUnderTest under_test(const Adapter& bsdf) {
  constexpr std::size_t n = Adapter::dimensions;
  return {n,
          [&bsdf](const Vec3<double>& out, const std::vector<double>& u) -> std::optional<BsdfSample> {
            std::array<double, n> numbers;
            std::copy_n(u.begin(), n, numbers.begin());
            return bsdf.sample(out, numbers);
          },
          [&bsdf](const Vec3<double>& out, const Vec3<double>& in) -> Rgb<double> { return bsdf.eval(out, in); },
          [&bsdf](const Vec3<double>& out, const Vec3<double>& in) -> double { return bsdf.pdf(out, in); }};
}

/// The expectation of check_bsdf: the checks that failed, each with what it says and where. Throws
/// what check_bsdf and trial_at do.
Expectation expect_bsdf(const Site& site, const BsdfUnderTest& bsdf, const BsdfTerms& terms = {});

}  // namespace fairlight

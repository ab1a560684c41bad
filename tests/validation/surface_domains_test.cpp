#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <support/run_seed.h>

#include <fairlight/validation/claims/reflectances.h>
#include <fairlight/validation/claims/surface_identities.h>
#include <fairlight/validation/faults/wrong_microfacet.h>

namespace fairlight {
namespace {

constexpr CosineRange head_on{"head_on", 1 - 1e-9, 1};

// ((n - 1) / (n + 1))^2, times (1 + 1 / (n^2 - 1))^2: for n = 1.5, 0.04 times 1.8^2.
TEST(InsulatorOutside, ReflectsHeadOnByTheIndexAlone) {
  const auto row = insulator_outside(head_on, {1.25, 1.5, 3});
  EXPECT_NEAR(row.references.at(0).mean, 625.0 / 6561, 1e-7);
  EXPECT_NEAR(row.references.at(1).mean, 0.1296, 1e-7);
  EXPECT_NEAR(row.references.at(2).mean, 0.25 * 81 / 64, 1e-7);
}

// From an index of 2 the critical cosine is sqrt(3)/2, and all cosines up to 1 are drawn.
TEST(InsulatorInside, ReflectsAllBelowTheCriticalCosine) {
  const auto row = insulator_inside("inside", false, {1.0001, 1.5, 2});
  const double critical = std::sqrt(3.0) / 2;
  EXPECT_GT(row.references.at(2).mean, critical + (1 - critical) / 9);
  EXPECT_LT(row.references.at(2).mean, 1);
  // Twice the critical cosine of 0.01414: half of the cosines reflect all.
  EXPECT_GT(row.references.at(0).mean, 0.5);
  EXPECT_LT(row.references.at(0).mean, 0.6);
}

// ((eta - 1)^2 + k^2) / ((eta + 1)^2 + k^2).
TEST(MetalReflectance, IsThatOfItsComplexIndexHeadOn) {
  const auto row = metal_reflectance(head_on, {1, 2, 1.5, 0, 2, 1});
  EXPECT_NEAR(row.references.at(0).mean, 0.5, 1e-7);
  EXPECT_NEAR(row.references.at(1).mean, 0.04, 1e-7);
  EXPECT_NEAR(row.references.at(2).mean, 0.2, 1e-7);
}

TEST(WorstGap, IsRelativeToTheLargerMagnitude) {
  const Rgb<double> x(1, 0, 2), y(1, 1e-6, 1);
  EXPECT_DOUBLE_EQ(detail::worst_gap<double>(x, y, 1e-3), 0.5);
  EXPECT_DOUBLE_EQ(detail::worst_gap<double>(Rgb<double>(0, 0, 0), Rgb<double>(0, 1e-6, 0), 1e-3), 1e-3);
}

template <class Row>
Verdict verdict_of(const Row& row) {
  const Trial trial{"surface_domains_test", testing::run_seed(), 1e-6, 0.01, 0.05};
  return constant_claim<double>(row).check(trial).verdict;
}

/// A surface whose f knows which direction is which.
struct OneWay : Lambertian<double> {
  using Lambertian<double>::Lambertian;
  Rgb<double> eval(const Vec3<double>& out, const Vec3<double>& in) const {
    return Lambertian<double>::eval(out, in) * (1 + 0.1 * out.z());
  }
};
struct AnyOneWay {
  static constexpr const char* name = "one_way";
  static constexpr const char* subject = "Lambertian";
  template <class Real>
  static OneWay make(auto& source) {
    return OneWay(detail::any_colour<double>(source));
  }
};

TEST(SurfaceIdentities, HoldOfARightSurfaceAndOfNoWrongOne) {
  EXPECT_EQ(verdict_of(bounce_identity<AnyMixture>()), Verdict::certified);
  EXPECT_EQ(verdict_of(reciprocity<AnyMixture>()), Verdict::certified);
  EXPECT_EQ(verdict_of(bounce_identity<AnyRoughMetal<faults::FresnelAtTheNormal>>()), Verdict::biased);
  EXPECT_EQ(verdict_of(bounce_identity<AnyOneWay>()), Verdict::biased);
  EXPECT_EQ(verdict_of(reciprocity<AnyOneWay>()), Verdict::biased);
}

}  // namespace
}  // namespace fairlight

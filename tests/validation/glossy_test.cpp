#include <cmath>

#include <boost/math/special_functions/beta.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/unit_square.h>

#include <fairlight/stats/quadrature.h>
#include <fairlight/validation/claims/glossy.h>

namespace fairlight {
namespace {

TEST(GlossyReflectance, IsOneAtNormalIncidence) {
  EXPECT_EQ(glossy_reflectance(5, 0), 1);
  EXPECT_NEAR(glossy_reflectance(5, 1e-4), 1, 1e-7);
}

TEST(GlossyReflectance, OfExponentZeroIsOneHalfAtGrazing) {
  EXPECT_NEAR(glossy_reflectance(0, M_PI / 2), 0.5, 1e-12);
}

TEST(GlossyReflectance, IsABetaFunctionAtGrazing) {
  for (double n : {1.0, 5.0, 100.0}) {
    EXPECT_NEAR(glossy_reflectance(n, M_PI / 2), (n + 2) / (2 * M_PI) * boost::math::beta((n + 1) / 2, 1.5), 1e-12);
  }
}

// For n = 1, f = 3 / (2 pi) max(0, m.w), which over the hemisphere, in its own height and turn, is integrated directly.
TEST(GlossyReflectance, AgreesWithTheIntegralOverTheHemisphere) {
  const double theta = 0.7;
  const Integral direct = integrate_rectangle(
      [=](double z, double phi) {
        const double cosine = z * std::cos(theta) + std::sqrt(1 - z * z) * std::cos(phi) * std::sin(theta);
        return 3 / (2 * M_PI) * std::max(cosine, 0.0) * z;
      },
      0, 1, 0, 2 * M_PI);
  EXPECT_NEAR(glossy_reflectance(1, theta), direct.value, 1e-7);
}

RC_GTEST_PROP(GlossyReflectance, FallsFromOneWithTheAngle, ()) {
  const double n = std::pow(10.0, 6 * *testing::unit_number()) - 1;
  const double theta = M_PI / 2 * *testing::unit_number();
  const double less = theta * *testing::unit_number();
  RC_ASSERT(glossy_reflectance(n, theta) <= glossy_reflectance(n, less) + 1e-9);
  RC_ASSERT(glossy_reflectance(n, less) <= 1 + 1e-9);
}

}  // namespace
}  // namespace fairlight

#include <cmath>
#include <limits>
#include <string>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/materials.h>

#include <fairlight/estimators/fresnel.h>
#include <fairlight/stats/quadrature.h>
#include <fairlight/validation/claims/fresnel.h>

namespace fairlight {
namespace {

using testing::cosine_to_grazing;
using testing::index_of_refraction;
using testing::lanes_of;
constexpr double ulp1 = ulp<double>;

// The textbook form, which cancels, evaluated with 34 decimal digits.
double textbook(double cosine, double eta) {
  if (eta == 1) return 0;
  using Wide = boost::multiprecision::cpp_bin_float_quad;
  const Wide c = cosine;
  const Wide n = eta;
  const Wide square = 1 - (1 - c * c) / (n * n);
  if (square < 0) return 1;
  const Wide t = sqrt(square);
  const Wide across = (c - n * t) / (c + n * t);
  const Wide along = (n * c - t) / (n * c + t);
  return static_cast<double>((across * across + along * along) / 2);
}

TEST(FresnelDielectric, IsKnownByHandAtNormalIncidence) {
  EXPECT_DOUBLE_EQ(fresnel_dielectric(1.0, 1.5), 0.04);        // (0.5 / 2.5)^2
  EXPECT_DOUBLE_EQ(fresnel_dielectric(1.0, 3.0), 0.25);        // (2 / 4)^2
  EXPECT_DOUBLE_EQ(fresnel_dielectric(1.0, 1.0 / 3.0), 0.25);  // the same from both sides
}

// At Brewster's angle, tan i = n, light polarised in the plane of incidence is not reflected. The
// perpendicular amplitude is sin(i - t) = (n^2 - 1) / (n^2 + 1), as i + t is a right angle.
TEST(FresnelDielectric, LosesOnePolarisationAtBrewstersAngle) {
  const double cosine = 1 / std::sqrt(1 + 1.5 * 1.5);
  EXPECT_NEAR(fresnel_dielectric(cosine, 1.5), std::pow(1.25 / 3.25, 2) / 2, 1e-16);
}

TEST(FresnelDielectric, ReflectsAllBeyondTheCriticalAngle) {
  const double critical = std::sqrt(1 - 0.25);  // sin = 1/2 = eta
  EXPECT_EQ(fresnel_dielectric(critical - 1e-12, 0.5), 1);
  EXPECT_LT(fresnel_dielectric(critical + 1e-12, 0.5), 1);
  EXPECT_EQ(fresnel_dielectric(0.0, 0.5), 1);
}

TEST(FresnelDielectric, ReflectsAllAtTheHorizonAndNothingWhereNothingIs) {
  EXPECT_DOUBLE_EQ(fresnel_dielectric(0.0, 1.5), 1);
  for (double cosine : {0.0, 1e-300, 1e-6, 0.5, 1.0}) EXPECT_EQ(fresnel_dielectric(cosine, 1.0), 0) << cosine;
  for (float cosine : {0.0f, 1e-30f, 1e-6f, 0.5f, 1.0f}) EXPECT_EQ(fresnel_dielectric(cosine, 1.0f), 0) << cosine;
}

// The refracted cosine is the root of eta^2 - 1 + c^2, which is a difference if eta < 1. Rounding
// the arguments alone then changes g by ulp c^2 / g. The logarithm of F has the slope 4 / (c + g)
// in g, so F changes accordingly.
RC_GTEST_PROP(FresnelDielectric, LosesNothingToCancellation, ()) {
  const double cosine = *cosine_to_grazing();
  const double eta = *index_of_refraction();
  const double exact = textbook(cosine, eta);
  const double g = std::sqrt(std::abs(detail::refracted_square(cosine, eta)));
  const double conditioning = eta < 1 ? 4 * cosine * cosine / (g * (cosine + g)) : 0;
  RC_ASSERT(std::abs(fresnel_dielectric(cosine, eta) - exact) <= 16 * ulp1 * exact * (1 + conditioning));
}

RC_GTEST_PROP(FresnelDielectric, IsTheSameFromBothSides, ()) {
  const double cosine = *cosine_to_grazing();
  const double index = *index_of_refraction();
  const double eta = std::max(index, 1 / index);
  const double g = std::sqrt(detail::refracted_square(cosine, eta));
  // As above, plus the rounding of 1 / eta and of the refracted cosine.
  const double conditioning = eta > 1 ? 4 * (1 + g * g) / (cosine * (cosine + g)) + 2 * eta / (eta - 1) : 0;
  const double out = fresnel_dielectric(cosine, eta);
  RC_ASSERT(std::abs(fresnel_dielectric(g / eta, 1 / eta) - out) <= 16 * ulp1 * out * (1 + conditioning));
}

// Avoids grazing and critical angles, where the angles are less accurate than their cosines.
RC_GTEST_PROP(FresnelDielectric, IsTheAnglesForm, ()) {
  const double cosine = *testing::between(0.01, 1);
  const double eta = *rc::gen::arbitrary<bool>() ? *testing::between(1.01, 3) : 1 / *testing::between(1.01, 3);
  const double g = std::sqrt(std::abs(detail::refracted_square(cosine, eta)));
  const double angles = fresnel_by_angles(std::acos(cosine), eta);
  RC_ASSERT(std::abs(fresnel_dielectric(cosine, eta) - angles) <= 1e-14 / (cosine * g));
}

TEST(FresnelConductor, IsKnownByHandAtNormalIncidence) {
  EXPECT_DOUBLE_EQ(fresnel_conductor(1.0, 1.0, 2.0), 0.5);        // k^2 / (4 + k^2) = 4 / 8
  EXPECT_DOUBLE_EQ(fresnel_conductor(1.0, 2.0, 3.0), 10.0 / 18);  // (1 + 9) / (9 + 9)
  EXPECT_DOUBLE_EQ(fresnel_conductor(0.0, 2.0, 3.0), 1);
  EXPECT_EQ(fresnel_conductor(0.0, 1.0, 0.0), 0);
}

RC_GTEST_PROP(FresnelConductor, IsTheAmplitudesForm, ()) {
  const double cosine = *cosine_to_grazing();
  const double eta = *testing::between(0.05, 10);
  const double k = *testing::between(0.01, 10);
  const double exact = fresnel_by_amplitudes(std::acos(cosine), {eta, k});
  RC_ASSERT(std::abs(fresnel_conductor(cosine, eta, k) - exact) <= 1e-12);
}

RC_GTEST_PROP(FresnelConductor, ThatAbsorbsNothingIsADielectric, ()) {
  const double cosine = *cosine_to_grazing();
  const double eta = *index_of_refraction();
  RC_ASSERT(std::abs(fresnel_conductor(cosine, eta, 0.0) - fresnel_dielectric(cosine, eta)) <= 16 * ulp1);
}

void expect_in_packets(double exact, const Packet& value) {
  for (double lane : lanes_of(value)) EXPECT_NEAR(lane, exact, 1e-6);
}

// A cosine may leave [0,1] by rounding.
template <class Real>
void expect_defined_in_its_domain_only() {
  const Real rounding(256 * ulp<Real>);
  for (const Real edge : {Real(0), Real(1)}) {  // the slope there is below 16
    const Real beyond = edge + (2 * edge - 1) * rounding;
    const auto differs = [&](const auto& f) { return std::abs(f(beyond) - f(edge)) / rounding; };
    EXPECT_LE(differs([](Real c) { return fresnel_dielectric(c, Real(1.5)); }), 16) << edge;
    EXPECT_LE(differs([](Real c) { return fresnel_conductor(c, Real(1.5), Real(2)); }), 16) << edge;
  }
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  for (const Real cosine : {Real(-0.5), Real(1.5), nan}) {
    EXPECT_TRUE(std::isnan(fresnel_dielectric(cosine, Real(1.5)))) << cosine;
    EXPECT_TRUE(std::isnan(fresnel_dielectric(cosine, Real(0.5)))) << cosine;
    EXPECT_TRUE(std::isnan(fresnel_conductor(cosine, Real(1.5), Real(2)))) << cosine;
  }
  for (const Real eta : {Real(0), Real(-1.5), nan, infinity<Real>}) {
    EXPECT_TRUE(std::isnan(fresnel_dielectric(Real(0.5), eta))) << eta;
    EXPECT_TRUE(std::isnan(fresnel_conductor(Real(0.5), eta, Real(2)))) << eta;
  }
  EXPECT_TRUE(std::isnan(fresnel_conductor(Real(0.5), Real(1.5), Real(-2))));
  EXPECT_TRUE(std::isnan(fresnel_conductor(Real(0.5), Real(1.5), nan)));
}

TEST(Fresnel, IsNotANumberOutsideItsDomain) {
  expect_defined_in_its_domain_only<double>();
  expect_defined_in_its_domain_only<float>();
  EXPECT_TRUE(all(xsimd::isnan(fresnel_dielectric(Packet(0.5f), Packet(-1.0f)))));
  EXPECT_TRUE(all(xsimd::isnan(fresnel_conductor(Packet(-0.5f), Packet(1.5f), Packet(2.0f)))));
}

TEST(Fresnel, IsTheSameInPackets) {
  for (float cosine : {1e-6f, 0.1f, 0.5f, 0.75f, 1.0f}) {
    for (float eta : {1.0f / 3, 1.0f, 1.000001f, 1.5f, 3.0f}) {
      SCOPED_TRACE(std::to_string(cosine) + " " + std::to_string(eta));
      expect_in_packets(fresnel_dielectric<double>(cosine, eta), fresnel_dielectric(Packet(cosine), Packet(eta)));
    }
    for (float eta : {0.0625f, 0.25f, 3.0f}) {
      for (float k : {0.0f, 3.5f, 10.0f}) {
        SCOPED_TRACE(std::to_string(cosine) + " " + std::to_string(eta) + " " + std::to_string(k));
        expect_in_packets(fresnel_conductor<double>(cosine, eta, k),
                          fresnel_conductor(Packet(cosine), Packet(eta), Packet(k)));
      }
    }
  }
}

TEST(DiffuseReflectance, IsTheIntegralOfFresnels) {
  for (double n : {1.1, 1.5, 2.5}) {
    const auto reflected = [](double eta) {
      return integrate_rectangle([eta](double i, double) { return fresnel_by_angles(i, eta) * std::sin(2 * i); }, 0,
                                 eta < 1 ? std::asin(eta) : std::numbers::pi / 2, 0, 1)
                 .value +
             (eta < 1 ? 1 - eta * eta : 0);
    };
    EXPECT_NEAR(diffuse_reflectance_outside(n), reflected(n), 1e-8) << n;
    EXPECT_NEAR(diffuse_reflectance_inside(n), reflected(1 / n), 1e-8) << n;
  }
}

}  // namespace
}  // namespace fairlight

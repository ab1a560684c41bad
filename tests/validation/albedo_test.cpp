#include <cmath>

#include <gtest/gtest.h>

#include <fairlight/estimators/energy_compensation.h>
#include <fairlight/estimators/glossy.h>
#include <fairlight/validation/claims/ggx_albedo.h>
#include <fairlight/validation/claims/glossy.h>
#include <fairlight/validation/claims/materials.h>

// What the surfaces say that they reflect, against quadratures of another kind, in other coordinates.
namespace fairlight {
namespace {

const Rgb<double> white = Rgb<double>::Ones();

Vec3<double> seen_at(double z, double azimuth) {
  const double sine = std::sqrt((1 - z) * (1 + z));
  return {sine * std::cos(azimuth), sine * std::sin(azimuth), z};
}

// The integral of f cos over the hemisphere, adaptive.
template <class Surface>
double integrated(const Surface& surface, const Vec3<double>& out, int channel) {
  const auto light = [&](double z, double phi) { return surface.eval(out, seen_at(z, phi))[channel] * z; };
  return integrate_rectangle(light, 0, 1, 0, 2 * std::numbers::pi).value;
}

TEST(Albedo, OfGlossyIsThatOfTheLobesCircles) {
  for (double exponent : {0.0, 0.25, 1.0, 5.0, 30.0, 1e3, 1e4}) {
    for (double theta : {0.0, 0.3, 0.8, 1.2, 1.5}) {
      const double albedo = Glossy<double>(white, exponent).albedo({0, std::sin(theta), std::cos(theta)})[0];
      EXPECT_NEAR(albedo, glossy_reflectance(exponent, theta), 1e-10) << exponent << ' ' << theta;
    }
  }
}

TEST(Albedo, OfARoughConductorIsThatOfItsSlopes) {
  for (double alpha_x : {1e-4, 0.03, 1.0}) {
    for (double alpha_y : {1e-4, 0.1, 0.5}) {
      const RoughConductor<double> surface({alpha_x, alpha_y}, ConstantReflectance<double>(white));
      for (double z : {1e-6, 0.01, 0.3, 0.9}) {
        const Vec3<double> out = seen_at(z, 2.2 * z);
        const double reference = GgxAlbedo{alpha_x, alpha_y}(out);
        EXPECT_NEAR(surface.albedo(out)[0], reference, 2e-6) << alpha_x << ' ' << alpha_y << ' ' << z;
      }
    }
  }
}

TEST(Albedo, OfARoughConductorCountsWhatItsFacetsReflect) {
  const RoughConductor<double, SchlickReflectance<double>> surface({0.5, 0.3},
                                                                   SchlickReflectance<double>({1, 0.5, 0}));
  for (double z : {0.1, 0.6, 1.0}) {
    const Vec3<double> out = seen_at(z, 0.7);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(surface.albedo(out)[c], integrated(surface, out, c), 2e-6) << z;
  }
}

// To the rounding of its fit, by which f may be off.
TEST(Albedo, OfAnEnergyCompensatedConductorIsTheIntegralOfBothItsLobes) {
  const EnergyCompensatedConductor<double> surface(0.5, ConstantReflectance<double>({1, 0.75, 0.25}));
  for (double z : {0.1, 0.6, 1.0}) {
    const Vec3<double> out = seen_at(z, 0.7);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(surface.albedo(out)[c], integrated(surface, out, c), 1e-6) << z;
  }
}

// Along the surface light is neither outside nor inside.
template <class Real>
void expect_no_energy_lost() {
  using std::abs;
  const Dielectric<Real> glass(Real(1.5f));
  for (double z : {1.0, 0.8, 1e-9, 0.0, -1e-9, -0.6, -0.8, -1.0}) {
    const Vec3<Real> out(rounded<Real>(std::sqrt((1 - z) * (1 + z))), Real(0), rounded<Real>(z));
    for (double u : {0.0, 0.5, 1 - 0x1p-24}) {
      const auto bounce = glass.sample(out, Eigen::Matrix<Real, 1, 1>(rounded<Real>(u)));
      const Real lost = energy_weight(glass, out, bounce) - Real(1);
      EXPECT_TRUE(all(abs(lost) <= Real(4 * ulp<Real>))) << z << ' ' << u;
    }
  }
}

TEST(EnergyWeight, IsOneFromAboveFromBelowAndAlongTheSurface) {
  expect_no_energy_lost<double>();
  expect_no_energy_lost<Packet>();
}

}  // namespace
}  // namespace fairlight

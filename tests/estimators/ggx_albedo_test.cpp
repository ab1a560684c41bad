#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include <fairlight/estimators/ggx_albedo.h>

namespace fairlight {
namespace {

// The stated accuracy of the quadrature, and the additional error of floats
// (estimators/ggx_albedo.h).
constexpr double stated = 2e-6, by_floats = 1e-6;

/// The albedo of white facets, which is the same in all lanes.
template <class Real>
double white(double alpha_x, double alpha_y, const Vec3<double>& out) {
  const auto one = [](const Real&) { return Real(1); };
  const auto albedo =
      ggx_albedo<Real>(Ggx<Real>(rounded<Real>(alpha_x), rounded<Real>(alpha_y)), out.cast<Real>(), one);
  std::array<double, lanes<Real>> values{};
  store_lanes(albedo, values.data());
  for (const double lane : values) EXPECT_EQ(lane, values[0]);
  return values[0];
}

template <class Real>
class GgxAlbedoIn : public ::testing::Test {
 public:
  static constexpr double apart = 2 * (stated + (lanes<Real> > 1 ? by_floats : 0));
};
using Arithmetics = ::testing::Types<double, Packet>;
TYPED_TEST_SUITE(GgxAlbedoIn, Arithmetics);

// Along both axes, where the integral over azimuths is split, and between them.
TYPED_TEST(GgxAlbedoIn, OfOneRoughnessIsTheSameAllRound) {
  const double ahead = white<TypeParam>(0.5, 0.5, {0.6, 0, 0.8});
  EXPECT_NEAR(white<TypeParam>(0.5, 0.5, {0, 0.6, 0.8}), ahead, this->apart);
  EXPECT_NEAR(white<TypeParam>(0.5, 0.5, {-0.36, 0.48, 0.8}), ahead, this->apart);
}

TYPED_TEST(GgxAlbedoIn, TurnsWithTheFacets) {
  EXPECT_NEAR(white<TypeParam>(0.1, 0.5, {0, 0.6, 0.8}), white<TypeParam>(0.5, 0.1, {0.6, 0, 0.8}), this->apart);
  EXPECT_NEAR(white<TypeParam>(0.1, 0.5, {0.48, 0.36, 0.8}), white<TypeParam>(0.5, 0.1, {0.36, -0.48, 0.8}),
              this->apart);
}

TYPED_TEST(GgxAlbedoIn, OfSmoothFacetsIsOne) {
  EXPECT_NEAR(white<TypeParam>(1e-3, 1e-3, {0, 0.6, 0.8}), 1, this->apart);
}

// In floats, z^2 slope^2 is lost in the rounding of k^2 here.
TEST(GgxAlbedo, KeepsItsDigitsNearTheHorizon) {
  const double z = 1e-4, x = std::sqrt((1 - z) * (1 + z));
  for (const Vec3<double>& out : {Vec3<double>(x, 0, z), Vec3<double>(0.6 * x, 0.8 * x, z)}) {
    EXPECT_NEAR(white<Packet>(0.5, 0.5, out), white<double>(0.5, 0.5, out), 2 * stated + by_floats);
  }
}

}  // namespace
}  // namespace fairlight

#include <bit>
#include <cstdint>
#include <stdexcept>

#include <gtest/gtest.h>

#include <fairlight/estimators/allocation.h>
#include <fairlight/estimators/blackman_harris_filter.h>
#include <fairlight/estimators/choose_light.h>
#include <fairlight/estimators/conductor.h>
#include <fairlight/estimators/cone.h>
#include <fairlight/estimators/dielectric.h>
#include <fairlight/estimators/filter.h>
#include <fairlight/estimators/gaussian_filter.h>
#include <fairlight/estimators/ggx.h>
#include <fairlight/estimators/hemisphere.h>
#include <fairlight/estimators/lambertian.h>
#include <fairlight/estimators/lens.h>
#include <fairlight/estimators/lobe.h>
#include <fairlight/estimators/mirror.h>
#include <fairlight/estimators/mixture.h>
#include <fairlight/estimators/rectangle_light.h>
#include <fairlight/estimators/reflectance.h>
#include <fairlight/estimators/roulette.h>
#include <fairlight/estimators/sphere_from_point.h>
#include <fairlight/estimators/splitting.h>

#if !defined(__FAST_MATH__)
#error "this file must be compiled with -ffast-math, as the code of many users is"
#endif

// Parameters that are no numbers are refused in what a user compiles with -ffast-math too.

namespace fairlight {
namespace {

template <class Real>
Real hidden(std::uint32_t bits) {
  volatile std::uint32_t word = bits;
  return Real(static_cast<Lane<Real>>(std::bit_cast<float>(std::uint32_t{word})));
}

#define EXPECT_REFUSED(statement) EXPECT_THROW((void)(statement), std::invalid_argument)

struct One {
  using Scalar = double;
  double estimate(auto& /*source*/) const { return 1; }
};

template <class Real>
void expect_refused(const Real& x) {
  const Vec3<Real> up(Real(0), Real(0), Real(1)), right(Real(1), Real(0), Real(0)), back(Real(0), Real(1), Real(0));
  const Rgb<Real> grey = Rgb<Real>::Constant(Real(0.5f)), colour(Real(0.5f), x, Real(0.5f));
  EXPECT_REFUSED(PowerCosineLobe<Real>(up, x));
  EXPECT_REFUSED(PowerCosineLobe<Real>(Vec3<Real>(Real(0), x, Real(1)), Real(1)));
  EXPECT_REFUSED(Dielectric<Real>{x});
  EXPECT_REFUSED(Conductor<Real>(colour, grey));
  EXPECT_REFUSED(Conductor<Real>(grey, colour));
  EXPECT_REFUSED(FresnelReflectance<Real>(colour, grey));
  EXPECT_REFUSED(SchlickReflectance<Real>{colour});
  EXPECT_REFUSED(Mirror<Real>{colour});
  EXPECT_REFUSED((Lambertian<Real, CosineHemisphere>{colour}));
  EXPECT_REFUSED(Ggx<Real>(Real(0.5f), x));
  EXPECT_REFUSED(BlackmanHarrisFilter<Real>{x});
  EXPECT_REFUSED(BoxFilter<Real>{x});
  EXPECT_REFUSED(GaussianFilter<Real>(x, Real(1)));
  EXPECT_REFUSED(GaussianFilter<Real>(Real(1), x));
  EXPECT_REFUSED(UniformCone<Real>{x});
  EXPECT_REFUSED(UniformCone<Real>::of_sine_squared(x));
  EXPECT_REFUSED(CircularAperture<Real>{x});
  EXPECT_REFUSED(PolygonalAperture<Real>(Real(1), 6, x));
  EXPECT_REFUSED(RussianRoulette::play(x, Real(0.5f)));
  EXPECT_REFUSED(SphereLight<Real>(up, x));
  EXPECT_REFUSED(SphereLight<Real>(Vec3<Real>(Real(0), x, Real(1)), Real(1)));
  EXPECT_REFUSED(RectangleLight<Real>(up, Vec3<Real>(x, Real(0), Real(0)), back));
  EXPECT_REFUSED(RectangleLight<Real>(Vec3<Real>(Real(0), x, Real(0)), right, back));
  const Mirror<Real> mirror(grey);
  EXPECT_REFUSED(Mixture(WeightedLobe{mirror, x, Real(0.5f)}, WeightedLobe{mirror, Real(1), Real(0.5f)}));
  EXPECT_REFUSED(Mixture(WeightedLobe{mirror, Real(1), x}, WeightedLobe{mirror, Real(1), Real(0.5f)}));
}

TEST(ParametersWithFastMath, ThatAreNoNumbersAreRefused) {
  for (const std::uint32_t bits : {0x7FC00000u, 0x7F800000u, 0xFF800000u}) {  // NaN, infinity, minus infinity
    SCOPED_TRACE(bits);
    expect_refused(hidden<double>(bits));
    expect_refused(hidden<Packet>(bits));
    const auto x = hidden<double>(bits);
    EXPECT_REFUSED(PowerChoice<double>({1, x}));
    EXPECT_REFUSED(share_out(10, {1, x}, 1));
    EXPECT_REFUSED(Splitting(One(), x));
    EXPECT_REFUSED(Rouletted(One(), x));
  }
}

// A lens may be focused at infinity.
TEST(ThinLensWithFastMath, RefusesADistanceThatIsNone) {
  const CircularAperture<double> aperture(1);
  EXPECT_REFUSED(ThinLens(hidden<double>(0x7FC00000u), aperture));
  EXPECT_REFUSED(ThinLens(hidden<double>(0xFF800000u), aperture));
  EXPECT_NO_THROW(ThinLens(hidden<double>(0x7F800000u), aperture));
}

TEST(AllFinite, KnowsNumbersByTheirBits) {
  for (const double x : {0.0, -1.0, 1e-310, 1.7e308}) EXPECT_TRUE(all_finite(x));
  for (const std::uint32_t bits : {0x7FC00000u, 0x7F800000u, 0xFF800000u, 0x7F800001u}) {
    EXPECT_FALSE(all_finite(hidden<double>(bits)));
    EXPECT_FALSE(all_finite(hidden<float>(bits)));
    EXPECT_FALSE(all_finite(hidden<Packet>(bits)));
  }
}

}  // namespace
}  // namespace fairlight

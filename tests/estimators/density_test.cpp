#include <concepts>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/estimators/density.h>

namespace fairlight {
namespace {

template <class A, class B>
concept Mixable = requires(A a, B b) {
  a* b;
}
|| requires(A a, B b) { a + b; }
|| requires(A a, B b) { a = b; };

static_assert(!Mixable<Density<Area, double>, Density<SolidAngle, double>>, "measures do not mix");
static_assert(!std::convertible_to<double, Density<Area, double>>, "a number is not yet a density");
static_assert(!std::convertible_to<Density<Area, double>, double>);
static_assert(Mixable<Density<Discrete, double>, Density<Area, double>>, "choosing, then sampling");

TEST(Density, TurnsAreaIntoSolidAngleByDistanceSquaredAndCosine) {
  const Density<Area, double> area(3);
  EXPECT_EQ(to_solid_angle(area, 2.0, 0.5).value(), 24);
  EXPECT_EQ(to_area(to_solid_angle(area, 2.0, 0.5), 2.0, 0.5).value(), 3);
}

TEST(Density, OfAChoiceAndADrawIsTheirProduct) {
  const Density<SolidAngle, double> both = Density<Discrete, double>(0.25) * Density<SolidAngle, double>(8);
  EXPECT_EQ(both.value(), 2);
}

TEST(Density, DividesAnIntegrandIntoAnEstimate) { EXPECT_EQ((6.0 / Density<Area, double>(4)), 1.5); }

}  // namespace
}  // namespace fairlight

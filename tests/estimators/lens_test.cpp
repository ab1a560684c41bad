#include <array>
#include <cmath>
#include <stdexcept>
#include <type_traits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/filters.h>
#include <support/unit_square.h>

#include <fairlight/estimators/concepts.h>
#include <fairlight/estimators/lens.h>

namespace fairlight {
namespace {

static_assert(Sampler<CircularAperture<double>>);
static_assert(Sampler<PolygonalAperture<double>>);

constexpr auto disk = []<class Real>(std::type_identity<Real>) { return CircularAperture<Real>(Real(0.3f)); };
constexpr auto triangle = []<class Real>(std::type_identity<Real>) {
  return PolygonalAperture<Real>(Real(0.3f), 3, Real(0.25));
};
constexpr auto heptagon = []<class Real>(std::type_identity<Real>) {
  return PolygonalAperture<Real>(Real(0.3f), 7, Real(-2));
};

TEST(CircularAperture, IsOneOverItsArea) {
  const CircularAperture<double> aperture(2);
  EXPECT_DOUBLE_EQ(aperture.pdf({0, 0}).value(), 1 / (4 * M_PI));
  EXPECT_DOUBLE_EQ(aperture.pdf({2, 0}).value(), 1 / (4 * M_PI));
  EXPECT_EQ(aperture.pdf({1.5, -1.5}).value(), 0);
}

TEST(CircularAperture, MapsSquaresToCircles) {
  const CircularAperture<double> aperture(2);
  EXPECT_EQ(aperture.sample({0.5, 0.5}), Vec2<double>(0, 0));
  EXPECT_TRUE(aperture.sample({0.75, 0.5}).isApprox(Vec2<double>(1, 0)));
  EXPECT_TRUE(aperture.sample({0.5, 0}).isApprox(Vec2<double>(0, -2)));
  EXPECT_TRUE(aperture.sample({0.75, 0.75}).isApprox(Vec2<double>(1, 1) / std::sqrt(2)));
  EXPECT_TRUE(aperture.sample({0.25, 0.25}).isApprox(Vec2<double>(-1, -1) / std::sqrt(2)));
}

TEST(PolygonalAperture, IsOneOverItsArea) {
  const PolygonalAperture<double> square(2, 4);  // corners at distance 2 on the axes, area 8
  EXPECT_DOUBLE_EQ(square.pdf({0, 0}).value(), 0.125);
  EXPECT_DOUBLE_EQ(square.pdf({1.99, 0}).value(), 0.125);
  EXPECT_DOUBLE_EQ(square.pdf({-0.9, 1.09}).value(), 0.125);
  EXPECT_EQ(square.pdf({-0.9, 1.11}).value(), 0);
  EXPECT_EQ(square.pdf({0, -2.01}).value(), 0);
  const PolygonalAperture<double> upright(2, 4, M_PI / 4);  // sides along the axes, at distance sqrt 2
  EXPECT_GT(upright.pdf({1.41, -1.41}).value(), 0);
  EXPECT_EQ(upright.pdf({1.99, 0}).value(), 0);
}

TEST(PolygonalAperture, HasItsCornersOnTheCircle) {
  const PolygonalAperture<double> square(2, 4);
  EXPECT_TRUE(square.sample({0, 0.5}).isApprox(Vec2<double>(0, 0)));
  EXPECT_TRUE(square.sample({1.0 / 16, 0.5}).isApprox(Vec2<double>(0.5, 0.5)));  // sqrt(1/4) of the way out
  EXPECT_TRUE(square.sample({0.25 - 0x1p-50, 0}).isApprox(Vec2<double>(2, 0)));
  EXPECT_TRUE(square.sample({0.5 - 0x1p-50, 0}).isApprox(Vec2<double>(0, 2)));
}

TEST(Aperture, KeepsItsPointsInsideAtTheEdgesOfTheSquare) {
  testing::expect_in_support_at_the_edges<double>(disk, 0.3f);
  testing::expect_in_support_at_the_edges<float>(disk, 0.3f);
  testing::expect_in_support_at_the_edges<Packet>(disk, 0.3f);
  testing::expect_in_support_at_the_edges<double>(triangle, 0.3f);
  testing::expect_in_support_at_the_edges<float>(triangle, 0.3f);
  testing::expect_in_support_at_the_edges<Packet>(triangle, 0.3f);
  testing::expect_in_support_at_the_edges<float>(heptagon, 0.3f);
  testing::expect_in_support_at_the_edges<Packet>(heptagon, 0.3f);
}

TEST(Aperture, IsTheSameInPackets) {
  testing::expect_packets_like_double(disk, 0.3, 2e-6, 1e-6);
  testing::expect_packets_like_double(triangle, 0.3, 2e-6, 1e-6);
  testing::expect_packets_like_double(heptagon, 0.3, 2e-6, 1e-6);
}

// Includes numbers near 1, whose points are near the rim, in floats, whose rounding is coarse.
RC_GTEST_PROP(Aperture, KeepsItsPointsInsideInFloats, ()) {
  const auto radius = static_cast<float>(std::exp(std::log(1e-3) + std::log(1e8) * *testing::unit_number()));
  const auto turn = static_cast<float>(-4 + 8 * *testing::unit_number());
  const int blades = *rc::gen::inRange(3, 20);
  const float near_one = 1 - 0x1p-24f * static_cast<float>(*rc::gen::inRange(1, 16));
  const auto other = static_cast<float>(*testing::unit_number()) * (1 - 0x1p-24f);
  const int blade = *rc::gen::inRange(1, blades + 1);
  const float end_of_blade = static_cast<float>(blade) / static_cast<float>(blades) * (1 - 0x1p-23f);
  const CircularAperture<float> circle(radius);
  const PolygonalAperture<float> polygon(radius, blades, turn);
  RC_ASSERT(circle.pdf(circle.sample({near_one, other})).value() > 0);
  RC_ASSERT(circle.pdf(circle.sample({other, near_one})).value() > 0);
  RC_ASSERT(polygon.pdf(polygon.sample({end_of_blade, other})).value() > 0);
  RC_ASSERT(polygon.pdf(polygon.sample({near_one, other})).value() > 0);
}

// |dx/du x dx/dv| = 1/p.
template <class Aperture>
double jacobian_times_density(const Aperture& aperture, const Vec2<double>& u) {
  constexpr double h = 1e-7;
  const Vec2<double> du =
      (aperture.sample(u + Vec2<double>(h, 0)) - aperture.sample(u - Vec2<double>(h, 0))) / (2 * h);
  const Vec2<double> dv =
      (aperture.sample(u + Vec2<double>(0, h)) - aperture.sample(u - Vec2<double>(0, h))) / (2 * h);
  return std::abs(du.x() * dv.y() - du.y() * dv.x()) * aperture.pdf(aperture.sample(u)).value();
}

RC_GTEST_PROP(CircularAperture, HasTheJacobianOneOverItsDensity, ()) {
  const Vec2<double> u = Vec2<double>::Constant(0.01) + 0.98 * *testing::unit_point();
  const Vec2<double> centred = u - Vec2<double>::Constant(0.5);
  RC_PRE(std::abs(std::abs(centred.x()) - std::abs(centred.y())) > 1e-6);  // creases along the diagonals
  RC_PRE(centred.norm() > 1e-3);
  RC_ASSERT(std::abs(jacobian_times_density(CircularAperture<double>(3), u) - 1) < 1e-5);
}

RC_GTEST_PROP(PolygonalAperture, HasTheJacobianOneOverItsDensity, ()) {
  const int blades = *rc::gen::inRange(3, 20);
  const Vec2<double> within = Vec2<double>::Constant(0.01) + 0.98 * *testing::unit_point();
  const double u = (*rc::gen::inRange(0, blades) + within.x()) / blades;
  const PolygonalAperture<double> aperture(3, blades, -4 + 8 * *testing::unit_number());
  RC_ASSERT(std::abs(jacobian_times_density(aperture, {u, within.y()}) - 1) < 1e-5);
}

TEST(Aperture, RefusesWhatIsNoOpening) {
  EXPECT_THROW(CircularAperture<double>{0}, std::invalid_argument);
  EXPECT_THROW(CircularAperture<double>{-1}, std::invalid_argument);
  EXPECT_THROW(CircularAperture<double>{std::nan("")}, std::invalid_argument);
  EXPECT_THROW(CircularAperture<double>{infinity<double>}, std::invalid_argument);
  EXPECT_THROW(CircularAperture<Packet>{Packet(0)}, std::invalid_argument);
  EXPECT_THROW(CircularAperture<float>{0.9e-18f}, std::invalid_argument);
  EXPECT_THROW(CircularAperture<float>{1.1e18f}, std::invalid_argument);
  EXPECT_THROW(PolygonalAperture<float>(0.9e-18f, 5), std::invalid_argument);
  EXPECT_LT(CircularAperture<float>{1e-18f}.pdf({0, 0}).value(), INFINITY);
  EXPECT_GT(CircularAperture<float>{1e18f}.pdf({0, 0}).value(), 0);
  EXPECT_THROW(PolygonalAperture<double>(0, 5), std::invalid_argument);
  EXPECT_THROW(PolygonalAperture<double>(std::nan(""), 5), std::invalid_argument);
  EXPECT_THROW(PolygonalAperture<double>(1, 2), std::invalid_argument);
  EXPECT_THROW(PolygonalAperture<double>(1, -3), std::invalid_argument);
}

TEST(ThinLens, BendsRaysToThePointInFocus) {
  const ThinLens lens(4.0, CircularAperture<double>(2));
  const LensRay<double> ray = lens.ray({0.5, 0, 1}, {0.75, 0.5});  // through (1, 0) of the lens, to (2, 0, 4)
  EXPECT_TRUE(ray.origin.isApprox(Vec3<double>(1, 0, 0)));
  EXPECT_TRUE(ray.direction.isApprox(Vec3<double>(0.25, 0, 1)));
}

TEST(ThinLens, SendsParallelRaysWhenFocusedAtInfinity) {
  const ThinLens lens(infinity<double>, CircularAperture<double>(2));
  EXPECT_EQ(lens.ray({0.5, 0.25, 1}, {0.3, 0.9}).direction, Vec3<double>(0.5, 0.25, 1));
}

// A point P at distance d, seen through the lens point l, appears in the pinhole's direction P/d +
// l (1/f - 1/d).
RC_GTEST_PROP(ThinLens, SpreadsAPointOverTheCircleOfConfusion, ()) {
  const auto length = [] { return std::exp(std::log(1e-3) + std::log(1e8) * *testing::unit_number()); };
  const double focus = length();
  const double distance = length();
  const double radius = length();
  const CircularAperture<double> aperture(radius);
  const Vec2<double> u = *testing::unit_point();
  const Vec2<double> l = aperture.sample(u);
  const Vec2<double> spread = l * (1 / focus - 1 / distance);
  const Vec2<double> point(0.5 * distance, -0.25 * distance);
  const Vec2<double> seen = point / distance + spread;
  const LensRay<double> ray = ThinLens(focus, aperture).ray({seen.x(), seen.y(), 1}, u);
  const Vec2<double> crossing = (ray.origin + ray.direction * distance).head<2>();
  const double scale = radius * (1 + distance / focus) + distance;
  RC_ASSERT((crossing - point).norm() <= 8 * ulp<double> * scale);
  RC_ASSERT(spread.norm() <= (1 + 1e-14) * radius * std::abs(distance - focus) / (focus * distance) +
                                 4 * ulp<double> * radius * (1 / focus + 1 / distance));
}

TEST(ThinLens, IsTheSameInPackets) {
  const ThinLens packets(Packet(2), CircularAperture<Packet>(Packet(0.25f)));
  const ThinLens lens(2.0, CircularAperture<double>(0.25));
  const LensRay<Packet> ray = packets.ray({Packet(0.75f), Packet(0.5f), Packet(1)}, {Packet(0.1f), Packet(0.7f)});
  std::array<double, lanes<Packet>> x{}, y{};
  store_lanes(ray.direction.x(), x.data());
  store_lanes(ray.direction.y(), y.data());
  const LensRay<double> expected = lens.ray({0.75, 0.5, 1}, {0.1, 0.7});
  for (std::size_t k = 0; k < x.size(); ++k) {
    EXPECT_NEAR(x[k], expected.direction.x(), 1e-6);
    EXPECT_NEAR(y[k], expected.direction.y(), 1e-6);
  }
}

TEST(ThinLens, RefusesAFocusThatIsNotInFront) {
  const CircularAperture<double> aperture(1);
  EXPECT_THROW(ThinLens(0.0, aperture), std::invalid_argument);
  EXPECT_THROW(ThinLens(-1.0, aperture), std::invalid_argument);
  EXPECT_THROW(ThinLens(std::nan(""), aperture), std::invalid_argument);
}

TEST(PolygonalAperture, RefusesARotationThatIsNoAngle) {
  EXPECT_THROW(PolygonalAperture<double>(1, 6, std::nan("")), std::invalid_argument);
  EXPECT_THROW(PolygonalAperture<double>(1, 6, infinity<double>), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

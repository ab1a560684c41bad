#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/lights.h>
#include <support/unit_square.h>

#include <fairlight/estimators/triangle_light.h>

namespace fairlight {
namespace {

using Light = TriangleLight<double>;
using Point = Vec3<double>;
constexpr double pi_ = std::numbers::pi;

static_assert(LightSampling<TriangleByArea<double>>);
static_assert(LightSampling<TriangleBySolidAngle<Packet>>);

// A face of the octahedron about the origin, an eighth of all directions, and half of a face of a cube.
const Light eighth({1, 0, 0}, {-1, 1, 0}, {-1, 0, 1});
const Light half_face({-1, -1, 1}, {2, 0, 0}, {2, 2, 0});
const Point origin(0, 0, 0);

TEST(TriangleBySolidAngle, IsOneOverTheSolidAngle) {
  const TriangleBySolidAngle<double> octant(eighth), twelfth(half_face);
  const Point diagonal = Point(1, 1, 1).normalized();
  EXPECT_NEAR(octant.pdf(origin, diagonal).value(), 8 / (4 * pi_), 1e-15);
  EXPECT_NEAR(octant.sample(origin, {0.3, 0.8}).density.value(), 8 / (4 * pi_), 1e-15);
  EXPECT_NEAR(twelfth.sample(origin, {0.3, 0.8}).density.value(), 12 / (4 * pi_), 1e-15);
  EXPECT_EQ(octant.pdf(origin, -diagonal).value(), 0);
  EXPECT_EQ(octant.pdf(origin, Point(1, 1, -0.01).normalized()).value(), 0);
}

TEST(TriangleBySolidAngle, HasItsCornersWhereTheSquareHasThem) {
  const TriangleBySolidAngle<double> light(eighth);
  const auto place = [&](double u, double v) {
    const auto sample = light.sample(origin, {u, v});
    return Point(sample.distance * sample.direction);
  };
  EXPECT_TRUE(place(0.5, 0).isApprox(Point(0, 1, 0), 1e-15));
  EXPECT_TRUE(place(0, 1 - 0x1p-53).isApprox(Point(1, 0, 0), 1e-12));
  EXPECT_TRUE(place(1 - 0x1p-53, 1 - 0x1p-53).isApprox(Point(0, 0, 1), 1e-12));
  // Half of the octant: the middle between the first and the third corner.
  EXPECT_TRUE(place(0.5, 1 - 0x1p-53).isApprox(Point(0.5, 0, 0.5), 1e-12));
}

TEST(TriangleByArea, HasTheDensityOfAreaTurnedIntoSolidAngle) {
  // The middle of the octahedron's face is 1 / sqrt(3) away, head-on; its area is sqrt(3) / 2.
  const TriangleByArea<double> light(eighth);
  EXPECT_NEAR(light.pdf(origin, Point(1, 1, 1).normalized()).value(), (1.0 / 3) / (std::sqrt(3) / 2), 1e-14);
  EXPECT_NEAR(light.sample(origin, {0, 0}).density.value(), 1 / (std::sqrt(3) / 2 / std::sqrt(3)), 1e-14);
  EXPECT_EQ(light.pdf(origin, Point(-1, -1, -1).normalized()).value(), 0);
}

TEST(TriangleLight, ShinesFromBothFaces) {
  const Point behind(2, 2, 2);
  const Point back = -Point(1, 1, 1).normalized();
  EXPECT_GT(TriangleByArea<double>(eighth).pdf(behind, back).value(), 0);
  EXPECT_LT(TriangleBySolidAngle<double>(eighth).sample(behind, {0.1, 0.2}).direction.dot(Point(1, 1, 1)), 0);
}

TEST(TriangleLight, IsNotSeenFromItsOwnPlane) {
  for (const Point& in_plane : {Point(3, 0, 1), Point(0, -0.5, 1), Point(-1, -1, 1)}) {
    for (const Vec2<double>& u : testing::edge_points()) {
      EXPECT_EQ(TriangleByArea<double>(half_face).sample(in_plane, u).density.value(), 0);
      EXPECT_EQ(TriangleBySolidAngle<double>(half_face).sample(in_plane, u).density.value(), 0);
    }
    EXPECT_EQ(TriangleBySolidAngle<double>(half_face).pdf(in_plane, {-1, 0, 0}).value(), 0);
  }
}

TEST(TriangleLight, RefusesWhatIsNoTriangle) {
  EXPECT_THROW(Light(origin, {0, 0, 0}, {0, 1, 0}), std::invalid_argument);
  EXPECT_THROW(Light(origin, {1, 0, 0}, {2, 0, 0}), std::invalid_argument);
  EXPECT_THROW(Light(origin, {1, 0, 0}, {1, 9e-5, 0}), std::invalid_argument);
  EXPECT_THROW(Light(origin, {1, 0, 0}, {0, std::nan(""), 0}), std::invalid_argument);
  EXPECT_NO_THROW(Light(origin, {1, 0, 0}, {1, 2e-4, 0}));
}

// Girard's excess of the angles at the corners, which is not the formula of the code.
double excess(const Point& a, const Point& b, const Point& c) {
  const auto angle = [](const Point& at, const Point& p, const Point& q) {
    const Point x = at.cross(p), y = at.cross(q);
    return std::atan2(x.cross(y).norm(), x.dot(y));
  };
  return angle(a, b, c) + angle(b, c, a) + angle(c, a, b) - pi_;
}

// The triangle to the corners A and B and the point of AC behind the sample has the fraction u of the
// solid angle, and on the arc from B to that point, 1 - cosine is v of the whole.
RC_GTEST_PROP(TriangleBySolidAngle, PutsThePartUOfTheSolidAngleBeside, ()) {
  const auto modest = [] { return *rc::gen::map(rc::gen::inRange(-300, 301), [](int i) { return i / 100.0; }); };
  const Point a(modest(), modest(), 1 + std::abs(modest()));
  const Point e(modest(), modest(), 0.1), f(modest(), modest(), -0.2);
  RC_PRE(e.cross(f).norm() > 0.1 * e.norm() * f.norm());
  RC_PRE(std::abs(a.dot(e.cross(f))) > 0.1);
  const Vec2<double> u = *testing::unit_point();
  RC_PRE(u.y() > 1e-6);
  const auto sample = TriangleBySolidAngle<double>(Light(a, e, f)).sample(origin, u);
  const Point hit = sample.distance * sample.direction, b = a + e, c = a + f;
  const double all = excess(a, b, c);
  RC_ASSERT(std::abs(sample.density.value() * all - 1) < 1e-11 / all);
  // The great circle through B and the sample meets that through A and C.
  Point d = b.cross(hit).cross(a.cross(c));
  if (d.dot(a + c) < 0) d = -d;
  RC_ASSERT(std::abs(excess(a, b, d) - u.x() * all) < 1e-8);
  const auto drop = [&](const Point& p) { return 1 - b.normalized().dot(p.normalized()); };
  RC_ASSERT(std::abs(drop(hit) - u.y() * drop(d)) < 1e-8);
}

// A triangle of a micron, a kilometre away, seen at an angle: of the solid angle A cos / d^2, in floats too.
template <class Real>
void expect_far_triangle(double tolerance) {
  const Vec3<Real> corner(Real(800), Real(0), Real(600)), e(Real(1e-6), Real(0), Real(0)),
      f(Real(0), Real(2e-6), Real(0));
  const TriangleBySolidAngle<Real> light(TriangleLight<Real>(corner, e, f));
  const auto sample = light.sample({Real(0), Real(0), Real(0)}, {Real(0.3), Real(0.6)});
  EXPECT_NEAR(static_cast<double>(sample.density.value()) * (1e-12 * 0.6 / 1e6), 1, tolerance);
  EXPECT_NEAR(static_cast<double>(sample.distance), 1000, 1000 * tolerance);
}
TEST(TriangleBySolidAngle, MayBeSmallAndFarAway) {
  expect_far_triangle<double>(1e-8);
  expect_far_triangle<float>(1e-5);
}

TEST(TriangleLight, TakesADirectionThatIsNearlyUnit) {
  const Point towards = Point(0.2, -0.3, 1).normalized();
  testing::expect_density_off_by_as_much_as_the_direction(TriangleByArea<double>(half_face), origin, towards);
  testing::expect_density_off_by_as_much_as_the_direction(TriangleBySolidAngle<double>(half_face), origin, towards);
}

TEST(TriangleLight, IsTheSameInPackets) {
  const auto packet = [](double x, double y, double z) { return testing::in_packets({x, y, z}); };
  const TriangleLight<Packet> packets(packet(-1, -1, 1), packet(2, 0, 0), packet(2, 2, 0));
  for (const Point& from : {origin, Point(3, -2, 0.5), Point(0.25, 0.5, 7)}) {
    for (const Vec2<double>& u :
         {Vec2<double>(0.125, 0.25), Vec2<double>(0.5, 0.75), Vec2<double>(0.625, 0.9375)}) {
      testing::expect_same_sample(TriangleByArea<double>(half_face), TriangleByArea<Packet>(packets), from, u);
      testing::expect_same_sample(TriangleBySolidAngle<double>(half_face), TriangleBySolidAngle<Packet>(packets),
                                  from, u);
    }
  }
}

}  // namespace
}  // namespace fairlight

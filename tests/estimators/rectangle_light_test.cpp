#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/lights.h>
#include <support/unit_square.h>

#include <fairlight/estimators/rectangle_light.h>

namespace fairlight {
namespace {

using Light = RectangleLight<double>;
using Point = Vec3<double>;

static_assert(LightSampling<RectangleByArea<double>>);
static_assert(LightSampling<RectangleBySolidAngle<Packet>>);

// A face of a cube of edge 2 about the origin fills a sixth of all directions.
const Light face({-1, -1, 1}, {2, 0, 0}, {0, 2, 0});
const Point origin(0, 0, 0);

TEST(RectangleBySolidAngle, IsOneOverTheSolidAngle) {
  const RectangleBySolidAngle<double> light(face);
  EXPECT_NEAR(light.pdf(origin, {0, 0, 1}).value(), 6 / (4 * M_PI), 1e-15);
  EXPECT_NEAR(light.sample(origin, {0.3, 0.8}).density.value(), 6 / (4 * M_PI), 1e-15);
  EXPECT_EQ(light.pdf(origin, {0, 0, -1}).value(), 0);
  EXPECT_EQ(light.pdf(origin, Point(1.01, 0, 1).normalized()).value(), 0);
}

TEST(RectangleBySolidAngle, HasItsCornersAndItsMiddleWhereTheSquareHasThem) {
  const RectangleBySolidAngle<double> light(face);
  const auto middle = light.sample(origin, {0.5, 0.5});
  EXPECT_TRUE(middle.direction.isApprox(Point(0, 0, 1), 1e-15));
  EXPECT_DOUBLE_EQ(middle.distance, 1);
  const auto corner = light.sample(origin, {0, 0});
  EXPECT_TRUE((corner.distance * corner.direction).isApprox(Point(-1, -1, 1), 1e-14));
  const auto other = light.sample(origin, {1 - 0x1p-53, 1 - 0x1p-53});
  EXPECT_TRUE((other.distance * other.direction).isApprox(Point(1, 1, 1), 1e-14));
}

TEST(RectangleByArea, HasTheDensityOfAreaTurnedIntoSolidAngle) {
  const RectangleByArea<double> light(face);
  EXPECT_DOUBLE_EQ(light.pdf(origin, {0, 0, 1}).value(), 0.25);
  EXPECT_NEAR(light.sample(origin, {0, 0}).density.value(), 3 * std::sqrt(3) / 4, 1e-15);
  EXPECT_EQ(light.pdf(origin, {0, 0, -1}).value(), 0);
}

TEST(RectangleLight, ShinesFromBothFaces) {
  const Point behind(0, 0, 2);
  EXPECT_DOUBLE_EQ(RectangleByArea<double>(face).pdf(behind, {0, 0, -1}).value(), 0.25);
  EXPECT_NEAR(RectangleBySolidAngle<double>(face).sample(behind, {0.1, 0.2}).density.value(), 6 / (4 * M_PI),
              1e-15);
  EXPECT_LT(RectangleBySolidAngle<double>(face).sample(behind, {0.1, 0.2}).direction.z(), 0);
}

TEST(RectangleLight, IsNotSeenFromItsOwnPlane) {
  for (const Point& in_plane : {Point(3, 0, 1), Point(0, 0, 1), Point(-1, -1, 1)}) {
    for (const Vec2<double>& u : testing::edge_points()) {
      EXPECT_EQ(RectangleByArea<double>(face).sample(in_plane, u).density.value(), 0);
      EXPECT_EQ(RectangleBySolidAngle<double>(face).sample(in_plane, u).density.value(), 0);
    }
    EXPECT_EQ(RectangleByArea<double>(face).pdf(in_plane, {-1, 0, 0}).value(), 0);
    EXPECT_EQ(RectangleBySolidAngle<double>(face).pdf(in_plane, {-1, 0, 0}).value(), 0);
  }
}

TEST(RectangleLight, RefusesWhatIsNoRectangle) {
  EXPECT_THROW(Light(origin, {0, 0, 0}, {0, 1, 0}), std::invalid_argument);
  EXPECT_THROW(Light(origin, {1, 0, 0}, {0.1, 1, 0}), std::invalid_argument);
  EXPECT_THROW(Light(origin, {1, 0, 0}, {0, std::nan(""), 0}), std::invalid_argument);
}

// The part of the rectangle below the sampled x fills the fraction u of the solid angle. The
// reference formula, a sum of atan(x y / (z r)) over four corners, cancels. So the lengths are
// within a factor of a thousand, where an error of an ulp in a point changes the solid angle by up
// to a thousand ulp.
RC_GTEST_PROP(RectangleBySolidAngle, PutsThePartUOfTheSolidAngleBelowX, ()) {
  const auto modest = [] { return *rc::gen::map(rc::gen::inRange(10, 1001), [](int i) { return i / 100.0; }); };
  const Point corner(modest() - 5, modest() - 5, modest());
  const double width = modest(), height = modest();
  const auto solid_angle = [&](double x0, double x1, double y0, double y1) {
    const auto beyond = [&](double x, double y) {
      return std::atan2(x * y, corner.z() * std::hypot(x, y, corner.z()));
    };
    return beyond(x1, y1) - beyond(x0, y1) - beyond(x1, y0) + beyond(x0, y0);
  };
  const Vec2<double> u = *testing::unit_point();
  const auto sample = RectangleBySolidAngle<double>(Light(corner, {width, 0, 0}, {0, height, 0})).sample(origin, u);
  const Point hit = sample.distance * sample.direction;
  const double all = solid_angle(corner.x(), corner.x() + width, corner.y(), corner.y() + height);
  const double part = solid_angle(corner.x(), hit.x(), corner.y(), corner.y() + height);
  RC_ASSERT(std::abs(sample.density.value() * all - 1) < 1e-14 / all);
  RC_ASSERT(std::abs(part - u.x() * all) < 1e-12);
  // v interpolates linearly between the sines of the edges, as seen at x.
  const auto sine = [&](double y) { return y / std::hypot(hit.x(), y, corner.z()); };
  const double top = sine(corner.y() + height), bottom = sine(corner.y());
  RC_ASSERT(std::abs(sine(hit.y()) - (bottom + u.y() * (top - bottom))) < 1e-12);
}

TEST(RectangleLight, TakesADirectionThatIsNearlyUnit) {
  const Point towards = Point(0.5, -0.25, 1).normalized();
  testing::expect_density_off_by_as_much_as_the_direction(RectangleByArea<double>(face), origin, towards);
  testing::expect_density_off_by_as_much_as_the_direction(RectangleBySolidAngle<double>(face), origin, towards);
}

TEST(RectangleLight, IsTheSameInPackets) {
  const auto packet = [](double x, double y, double z) { return testing::in_packets({x, y, z}); };
  const RectangleLight<Packet> packets(packet(-1, -1, 1), packet(2, 0, 0), packet(0, 2, 0));
  for (const Point& from : {origin, Point(3, -2, 0.5), Point(0.25, 0.5, 7)}) {
    for (const Vec2<double>& u :
         {Vec2<double>(0.125, 0.25), Vec2<double>(0.5, 0.75), Vec2<double>(0.625, 0.9375)}) {
      testing::expect_same_sample(RectangleByArea<double>(face), RectangleByArea<Packet>(packets), from, u);
      testing::expect_same_sample(RectangleBySolidAngle<double>(face), RectangleBySolidAngle<Packet>(packets), from,
                                  u);
    }
  }
}

TEST(RectangleLight, IsInItsDomainAtTheEdgesInPackets) {
  const auto packet = [](double x, double y, double z) { return testing::in_packets({x, y, z}); };
  for (double size : {1e-3, 1.0, 1e5}) {
    for (double plane : {0.0, 1e-3, 1.0, 1e5}) {
      for (double corner : {-0.5 * size, 0.0, 1e-3, 1e5}) {
        const RectangleLight<Packet> light(packet(corner, corner, plane), packet(size, 0, 0), packet(0, size, 0));
        testing::expect_finite_at_edges(RectangleByArea<Packet>(light), packet(0, 0, 0));
        testing::expect_finite_at_edges(RectangleBySolidAngle<Packet>(light), packet(0, 0, 0));
      }
    }
  }
}

TEST(RectangleLight, RefusesWhatIsNotFinite) {
  EXPECT_THROW(RectangleLight<double>({0, std::nan(""), 0}, {1, 0, 0}, {0, 1, 0}), std::invalid_argument);
  EXPECT_THROW(RectangleLight<double>({0, 0, 0}, {infinity<double>, 0, 0}, {0, 1, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

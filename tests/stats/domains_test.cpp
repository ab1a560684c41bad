#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/unit_square.h>

#include <fairlight/stats/domains.h>

namespace fairlight {
namespace {

template <class Domain>
void check_inverse(const Domain& domain) {
  EXPECT_TRUE(rc::check([domain] {
    const Eigen::Vector2d u = *testing::unit_point();
    RC_PRE(u.y() > 1e-9);  // the seam, where the turn jumps from 0 to 1
    const Eigen::Vector2d back = domain.coordinates(domain.at(u.x(), u.y()));
    RC_ASSERT((back - u).norm() < 1e-7);
  }));
}

// |dx/ds x dx/dt| is the constant size: cells of equal area in the square are cells of equal area in the domain.
template <class Domain>
void check_area(const Domain& domain, double scale) {
  EXPECT_TRUE(rc::check([domain, scale] {
    const Eigen::Vector2d u = Eigen::Vector2d::Constant(0.01) + 0.98 * *testing::unit_point();
    constexpr double h = 1e-6;
    const Eigen::Vector3d ds = (domain.at(u.x() + h, u.y()) - domain.at(u.x() - h, u.y())) / (2 * h);
    const Eigen::Vector3d dt = (domain.at(u.x(), u.y() + h) - domain.at(u.x(), u.y() - h)) / (2 * h);
    RC_ASSERT(std::abs(ds.cross(dt).norm() * scale / domain.size() - 1) < 1e-6);
  }));
}

// Where an eighth of a turn ends the two may round to different sides.
template <class Domain>
void check_eighths(const Domain& domain) {
  EXPECT_TRUE(rc::check([domain] {
    const Eigen::Vector2d u = *testing::unit_point();
    const double eighths = 8 * u.y();
    RC_PRE(u.x() > 1e-6 && u.x() < 1 - 1e-6 && std::abs(eighths - std::round(eighths)) > 1e-6);
    const auto x = domain.at(u.x(), u.y());
    RC_ASSERT(domain.eighths(x) == Eigen::Vector2d(domain.coordinates(x).x(), (std::floor(eighths) + 0.5) / 8));
  }));
}

TEST(Domains, WithATurnKnowItsEighths) {
  check_eighths(DiskDomain{2});
  check_eighths(HemisphereDomain{});
  check_eighths(CapDomain(0.5, {2.0 / 3, -1.0 / 3, 2.0 / 3}));
  check_eighths(SphereDomain{3});
  // A turn starts at -x; the point (-2,-1) is a bit further, and (2,1) half a turn on.
  EXPECT_EQ(DiskDomain{3}.eighths({-2, -1}).y(), 1.0 / 16);
  EXPECT_EQ(DiskDomain{3}.eighths({2, 1}).y(), 9.0 / 16);
}

TEST(Domains, HaveNoEighthForWhatIsNoPlace) {
  const double none = std::nan("");
  EXPECT_TRUE(std::isnan(DiskDomain{3}.eighths({none, 1}).y()));
  EXPECT_TRUE(std::isnan(SphereDomain{1}.eighths({1, none, 0}).y()));
}

TEST(HemisphereDomain, PreservesAreaAndInverts) {
  check_inverse(HemisphereDomain{});
  check_area(HemisphereDomain{}, 1);
}

TEST(CapDomain, PreservesAreaAndInverts) {
  check_inverse(CapDomain(1.5));
  check_area(CapDomain(1.5), 1);
  check_inverse(CapDomain(0.5, {2.0 / 3, -1.0 / 3, 2.0 / 3}));
  check_area(CapDomain(0.5, {2.0 / 3, -1.0 / 3, 2.0 / 3}), 1);
}

TEST(CapDomain, HasItsAxisAtOneEndAndItsEdgeAtTheOther) {
  const CapDomain cap(0.4, {0, 1, 0});
  EXPECT_TRUE(cap.at(0, 0.3).isApprox(Eigen::Vector3d(0, 1, 0)));
  EXPECT_DOUBLE_EQ(cap.at(1, 0.3).y(), 0.6);
  EXPECT_LE(std::abs(cap.coordinates({0, 1, 0}).x()), 1e-30);
}

TEST(LuneDomain, PreservesAreaAndInverts) {
  const LuneDomain lune({0.6, 0, 0.8}, {0, 0, 1});
  check_inverse(lune);
  check_area(lune, 1);
}

TEST(LuneDomain, LiesBetweenTheEdgesOfTwoHemispheres) {
  const LuneDomain quarter({1, 0, 0}, {0, 0, 1});
  EXPECT_DOUBLE_EQ(quarter.size(), M_PI);
  EXPECT_TRUE(quarter.at(0.5, 0).isApprox(Eigen::Vector3d(0, 0, 1))) << quarter.at(0.5, 0).transpose();
  EXPECT_TRUE(quarter.at(0.5, 1).isApprox(Eigen::Vector3d(1, 0, 0))) << quarter.at(0.5, 1).transpose();
  EXPECT_TRUE(quarter.at(1, 0.5).isApprox(Eigen::Vector3d(0, -1, 0))) << quarter.at(1, 0.5).transpose();
}

TEST(SphereDomain, PreservesAreaAndInverts) {
  check_inverse(SphereDomain{3});
  check_area(SphereDomain{3}, 9);
}

TEST(DiskDomain, PreservesAreaAndInverts) {
  check_inverse(DiskDomain{2});
  EXPECT_TRUE(DiskDomain{2}.at(0.25, 0.5).isApprox(Eigen::Vector2d(1, 0)));
  EXPECT_DOUBLE_EQ(DiskDomain{2}.size(), 4 * M_PI);
}

TEST(PolygonDomain, PreservesAreaAndInverts) {
  check_inverse(PolygonDomain{2, 5, 0.25});
  check_inverse(PolygonDomain{2, 4, 0});
  const PolygonDomain square{2, 4, 0};
  EXPECT_DOUBLE_EQ(square.size(), 8);
  EXPECT_TRUE(square.at(1, 0).isApprox(Eigen::Vector2d(2, 0))) << "the first corner";
  EXPECT_TRUE(square.at(0.25, 0.125).isApprox(Eigen::Vector2d(0.5, 0.5))) << "half way to the middle of a side";
  EXPECT_TRUE((PolygonDomain{2, 4, M_PI / 2}.at(1, 0).isApprox(Eigen::Vector2d(0, 2))));
}

// |dx/ds x dx/dt| is the constant size.
RC_GTEST_PROP(PolygonDomain, HasTheConstantJacobianOfItsArea, ()) {
  const PolygonDomain domain{2, *rc::gen::inRange(3, 12), 0.25};
  const double s = 0.01 + 0.98 * *testing::unit_number();
  const double t = (*rc::gen::inRange(0, domain.corners) + 0.01 + 0.98 * *testing::unit_number()) / domain.corners;
  constexpr double h = 1e-6;
  const Eigen::Vector2d ds = (domain.at(s + h, t) - domain.at(s - h, t)) / (2 * h);
  const Eigen::Vector2d dt = (domain.at(s, t + h) - domain.at(s, t - h)) / (2 * h);
  RC_ASSERT(std::abs((ds.x() * dt.y() - ds.y() * dt.x()) / domain.size() - 1) < 1e-6);
}

TEST(IntervalDomain, IgnoresTheSecondCoordinate) {
  const IntervalDomain interval{-1, 3};
  EXPECT_EQ(interval.at(0.25, 0.9), 0);
  EXPECT_EQ(interval.coordinates(1), Eigen::Vector2d(0.5, 0.5));
  EXPECT_EQ(interval.size(), 4);
}

TEST(DiscreteDomain, HasACellForEachNumber) {
  const DiscreteDomain die{6};
  EXPECT_EQ(die.at(0.99, 0), 5);
  EXPECT_EQ(die.coordinates(0).x(), 0.5 / 6);
}

TEST(SquareDomain, MapsItsCorners) {
  const SquareDomain square{-1, 1};
  EXPECT_EQ(square.at(0, 1), Eigen::Vector2d(-1, 1));
  EXPECT_EQ(square.coordinates({0, 0.5}), Eigen::Vector2d(0.5, 0.75));
  EXPECT_EQ(square.size(), 4);
  check_inverse(square);
}

}  // namespace
}  // namespace fairlight

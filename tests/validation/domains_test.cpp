#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/unit_square.h>

#include <fairlight/validation/domains.h>

namespace fairlight {
namespace {

template <class Domain>
void check_inverse(const Domain& domain) {
  rc::check([domain] {
    const Vec2<double> u = *testing::unit_point();
    RC_PRE(u.y() > 1e-9);  // the seam, where the turn jumps from 0 to 1
    const Vec2<double> back = domain.coordinates(domain.at(u.x(), u.y()));
    RC_ASSERT((back - u).norm() < 1e-7);
  });
}

// |dx/ds x dx/dt| is the constant size: cells of equal area in the square are cells of equal area in the domain.
template <class Domain>
void check_area(const Domain& domain, double scale) {
  rc::check([domain, scale] {
    const Vec2<double> u = Vec2<double>::Constant(0.01) + 0.98 * *testing::unit_point();
    constexpr double h = 1e-6;
    const Vec3<double> ds = (domain.at(u.x() + h, u.y()) - domain.at(u.x() - h, u.y())) / (2 * h);
    const Vec3<double> dt = (domain.at(u.x(), u.y() + h) - domain.at(u.x(), u.y() - h)) / (2 * h);
    RC_ASSERT(std::abs(ds.cross(dt).norm() * scale / domain.size() - 1) < 1e-6);
  });
}

TEST(HemisphereDomain, PreservesAreaAndInverts) {
  check_inverse(HemisphereDomain{});
  check_area(HemisphereDomain{}, 1);
}

TEST(SphereDomain, PreservesAreaAndInverts) {
  check_inverse(SphereDomain{3});
  check_area(SphereDomain{3}, 9);
}

TEST(SquareDomain, MapsItsCorners) {
  const SquareDomain square{-1, 1};
  EXPECT_EQ(square.at(0, 1), Vec2<double>(-1, 1));
  EXPECT_EQ(square.coordinates({0, 0.5}), Vec2<double>(0.5, 0.75));
  EXPECT_EQ(square.size(), 4);
  check_inverse(square);
}

}  // namespace
}  // namespace fairlight

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/unit_square.h>

#include <fairlight/estimators/concepts.h>
#include <fairlight/estimators/uniform_sphere_area.h>

namespace fairlight {
namespace {

static_assert(Sampler<UniformSphereArea<double>>);

TEST(UniformSphereArea, HasTheDensityOneOverItsArea) {
  EXPECT_DOUBLE_EQ(UniformSphereArea<double>(2).pdf({0, 0, 1}).value(), 1 / (16 * M_PI));
}

TEST(UniformSphereArea, TakesHeightFromTheFirstNumberAndTurnFromTheSecond) {
  const UniformSphereArea<double> sphere(5);
  EXPECT_EQ(sphere.sample({0, 0}), Vec3<double>(0, 0, 1));
  EXPECT_TRUE(sphere.sample({0.2, 0.25}).isApprox(Vec3<double>(0, 0.8, 0.6), 1e-15));
}

TEST(UniformSphereArea, IsInvertedByItsInverse) {
  const UniformSphereArea<double> sphere(5);
  EXPECT_TRUE(sphere.invert(sphere.sample({0.2, 0.25})).isApprox(Vec2<double>(0.2, 0.25), 1e-15));
}

TEST(UniformSphereArea, GivesUnitNormalsAtTheEdgesOfTheSquare) {
  for (const Vec2<double>& u : testing::edge_points()) {
    EXPECT_LE(std::abs(UniformSphereArea<double>(1).sample(u).norm() - 1), 4e-16) << u.transpose();
  }
}

RC_GTEST_PROP(UniformSphereArea, HasTheJacobianOneOverItsDensity, ()) {
  const double radius = *rc::gen::element(1e-3, 1.0, 1e5);
  const UniformSphereArea<double> sphere(radius);
  const Vec2<double> u = Vec2<double>::Constant(0.01) + 0.98 * *testing::unit_point();
  constexpr double h = 1e-6;
  const Vec3<double> du = (sphere.sample(u + Vec2<double>(h, 0)) - sphere.sample(u - Vec2<double>(h, 0))) / (2 * h);
  const Vec3<double> dv = (sphere.sample(u + Vec2<double>(0, h)) - sphere.sample(u - Vec2<double>(0, h))) / (2 * h);
  const double jacobian = radius * radius * du.cross(dv).norm() * sphere.pdf(sphere.sample(u)).value();
  RC_ASSERT(std::abs(jacobian - 1) < 1e-6);
}

TEST(UniformSphereArea, RefusesARadiusThatIsNotPositive) {
  EXPECT_THROW(UniformSphereArea<double>(0), std::invalid_argument);
  EXPECT_THROW(UniformSphereArea<double>(-1), std::invalid_argument);
  EXPECT_THROW(UniformSphereArea<double>(std::nan("")), std::invalid_argument);
}

TEST(UniformSphereArea, RefusesARadiusThatIsNotFinite) {
  EXPECT_THROW(UniformSphereArea<double>(infinity<double>), std::invalid_argument);
  EXPECT_THROW(UniformSphereArea<Packet>(Packet(infinity<float>)), std::invalid_argument);
  EXPECT_THROW(UniformSphereArea<double>(std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

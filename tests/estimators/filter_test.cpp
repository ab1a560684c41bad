#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/filters.h>
#include <support/unit_square.h>

#include <fairlight/estimators/concepts.h>
#include <fairlight/estimators/filter.h>

namespace fairlight {
namespace {

static_assert(Sampler<TentFilter<double>>);

static_assert(Sampler<BoxFilter<double>>);

constexpr auto box = []<class Real>(std::type_identity<Real>) { return BoxFilter<Real>(Real(0.5)); };

TEST(BoxFilter, IsOneOverItsArea) {
  EXPECT_EQ(BoxFilter<double>().pdf({0, 0}).value(), 1);
  EXPECT_EQ(BoxFilter<double>().pdf({0.5, -0.5}).value(), 1);
  EXPECT_EQ(BoxFilter<double>().pdf({0.51, 0}).value(), 0);
  EXPECT_EQ(BoxFilter<double>().pdf({0, -0.51}).value(), 0);
  EXPECT_EQ(BoxFilter<double>(2).pdf({-1.9, 1.9}).value(), 1.0 / 16);
}

TEST(BoxFilter, ScalesTheSquare) {
  EXPECT_EQ(BoxFilter<double>(2).sample({0.25, 0.75}), Vec2<double>(-1, 1));
  EXPECT_EQ(BoxFilter<double>().sample({0, 0.5}), Vec2<double>(-0.5, 0));
}

TEST(BoxFilter, StaysInItsDomainAtTheEdgesOfTheSquare) {
  testing::expect_in_support_at_the_edges<double>(box, 0.5);
  testing::expect_in_support_at_the_edges<float>(box, 0.5);
  testing::expect_in_support_at_the_edges<Packet>(box, 0.5);
}

TEST(BoxFilter, IsTheSameInPackets) { testing::expect_packets_like_double(box, 0.5, 1e-6, 1e-6); }

RC_GTEST_PROP(BoxFilter, HasTheJacobianOneOverItsDensity, ()) {
  const BoxFilter<double> filter(std::exp(std::log(1e-3) + std::log(1e8) * *testing::unit_number()));
  const Vec2<double> u = Vec2<double>::Constant(0.01) + 0.98 * *testing::unit_point();
  RC_ASSERT(testing::has_the_jacobian_one_over_its_density(filter, u, 1e-8));
}

TEST(BoxFilter, RefusesARadiusThatIsNone) { testing::expect_radius_refused<BoxFilter>(); }

TEST(TentFilter, IsOneAtTheCentreAndZeroAtTheNeighbours) {
  const TentFilter<double> tent;
  EXPECT_EQ(tent.pdf({0, 0}).value(), 1);
  EXPECT_EQ(tent.pdf({0.5, -0.5}).value(), 0.25);
  EXPECT_EQ(tent.pdf({1, 0}).value(), 0);
  EXPECT_EQ(tent.pdf({0, -1.5}).value(), 0);
}

TEST(TentFilter, InvertsItsDistributionFunction) {
  // P(X <= x) is (1 + x)^2 / 2 left of the centre, and 1 - (1 - x)^2 / 2 right of it.
  const Vec2<double> quarters = TentFilter<double>().sample({0.125, 0.875});
  EXPECT_DOUBLE_EQ(quarters.x(), -0.5);
  EXPECT_DOUBLE_EQ(quarters.y(), 0.5);
  // The middles of the first two steps of 2^-53: (1 + x)^2 = 2^-53 and 3 2^-53.
  const Vec2<double> first = TentFilter<double>().sample({0, std::ldexp(1, -53)});
  EXPECT_DOUBLE_EQ(first.x(), std::sqrt(std::ldexp(1, -53)) - 1);
  EXPECT_DOUBLE_EQ(first.y(), std::sqrt(std::ldexp(3, -53)) - 1);
}

// Code that divides by the density of a draw needs this.
TEST(TentFilter, HasADensityWhereverADrawFalls) {
  const auto expect_density = [](const auto& tent, const auto& u) {
    const auto x = tent.sample(u);
    EXPECT_LT(x.cwiseAbs().maxCoeff(), 1) << u.transpose();
    EXPECT_GT(tent.pdf(x).value(), 0) << u.transpose();
  };
  for (const Vec2<double>& u : testing::edge_points()) expect_density(TentFilter<double>(), u);
  for (const Vec2<float>& u : testing::edge_points<float>()) expect_density(TentFilter<float>(), u);
}

RC_GTEST_PROP(TentFilter, HasTheJacobianOneOverItsDensity, ()) {
  const TentFilter<double> tent;
  const Vec2<double> u = Vec2<double>::Constant(0.01) + 0.98 * *testing::unit_point();
  constexpr double h = 1e-7;
  RC_PRE((u.array() - 0.5).abs().minCoeff() > h);  // the tent has a kink there
  const Vec2<double> wide = (tent.sample(u + Vec2<double>(h, h)) - tent.sample(u - Vec2<double>(h, h))) / (2 * h);
  RC_ASSERT(std::abs(wide.prod() * tent.pdf(tent.sample(u)).value() - 1) < 1e-5);
}

// The density is 1 / (4 r^2) at both ends of the range. Beyond it the filter throws: 1e-30 squared
// underflows in floats.
TEST(BoxFilter, RefusesARadiusThatFloatsDoNotHold) {
  EXPECT_NEAR(static_cast<double>(BoxFilter<float>(1e-6f).pdf({0, 0}).value()) / 2.5e11, 1, 1e-6);
  EXPECT_NEAR(static_cast<double>(BoxFilter<float>(1e6f).pdf({0, 0}).value()) / 2.5e-13, 1, 1e-6);
  for (float wrong : {0.9e-6f, 1.1e6f, 1e-30f, 1e30f}) EXPECT_THROW(BoxFilter<float>{wrong}, std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

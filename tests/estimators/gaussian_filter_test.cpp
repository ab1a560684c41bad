#include <cmath>
#include <stdexcept>

#include <boost/math/special_functions/erf.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/filters.h>
#include <support/unit_square.h>

#include <fairlight/estimators/concepts.h>
#include <fairlight/estimators/gaussian_filter.h>

namespace fairlight {
namespace {

static_assert(Sampler<GaussianFilter<double>>);

constexpr auto half_pixel = []<class Real>(std::type_identity<Real>) {
  return GaussianFilter<Real>(Real(0.5), Real(1.5));
};
constexpr auto longest = []<class Real>(std::type_identity<Real>) {
  return GaussianFilter<Real>(Real(0.5), Real(2.5));
};
constexpr auto flat = []<class Real>(std::type_identity<Real>) {
  return GaussianFilter<Real>(Real(512), Real(0.5));
};

TEST(GaussianFilter, IsTheGaussianOverWhatIsKeptOfIt) {
  // Truncation at three deviations keeps erf(3/sqrt 2) = 0.99730020393674 along each axis.
  const GaussianFilter<double> filter(0.5, 1.5);
  const double centre = 1 / (2 * M_PI * 0.25 * 0.99730020393674 * 0.99730020393674);
  EXPECT_NEAR(filter.pdf({0, 0}).value(), centre, 1e-13);
  EXPECT_NEAR(filter.pdf({0.5, -0.5}).value(), centre * std::exp(-1), 1e-13);
  EXPECT_GT(filter.pdf({1.5, -1.5}).value(), 0);
  EXPECT_EQ(filter.pdf({0, 1.51}).value(), 0);
  EXPECT_EQ(filter.pdf({-1.51, 0}).value(), 0);
}

TEST(GaussianFilter, HasItsQuantilesWhereTheNormalDistributionHasThem) {
  // Half of the mass within five deviations is within 0.67448975 deviations (0.67448975019608
  // without truncation).
  const GaussianFilter<double> filter(2, 10);
  EXPECT_EQ(filter.sample({0.5, 0.5}), Vec2<double>(0, 0));
  EXPECT_NEAR(filter.sample({0.75, 0.25}).x(), 2 * 0.67448975019608, 2e-6);
  EXPECT_NEAR(filter.sample({0.75, 0.25}).y(), -2 * 0.67448975019608, 2e-6);
  EXPECT_EQ(filter.sample({0, 0}), Vec2<double>(-10, -10));
}

// To 8 ulp of the offset, however small. Boost's inverse is the independent reference.
RC_GTEST_PROP(GaussianFilter, InvertsItsDistributionFunctionToTheRounding, ()) {
  const double edge = std::exp(std::log(1e-3) + (std::log(5) - std::log(1e-3)) * *testing::unit_number());
  const double u = *testing::unit_number();
  const double x = GaussianFilter<double>(1, edge).sample({u, 0.5}).x();
  const double kept = std::erf(edge / std::sqrt(2));
  const double beyond = 2 * std::min(u, 1 - u);
  const double p = (1 - beyond) * kept;
  const double size =
      std::sqrt(2) *
      (p < 0.5 ? boost::math::erf_inv(p) : boost::math::erfc_inv(std::erfc(edge / std::sqrt(2)) + beyond * kept));
  RC_ASSERT(std::abs(std::abs(x) - size) <= 16 * 0x1p-53 * size);
  RC_ASSERT((x < 0) == (u < 0.5 && x != 0));
}

TEST(GaussianFilter, StaysInItsDomainAtTheEdgesOfTheSquare) {
  testing::expect_in_support_at_the_edges<double>(half_pixel, 1.5);
  testing::expect_in_support_at_the_edges<float>(half_pixel, 1.5);
  testing::expect_in_support_at_the_edges<Packet>(half_pixel, 1.5);
  testing::expect_in_support_at_the_edges<double>(longest, 2.5);
  testing::expect_in_support_at_the_edges<float>(longest, 2.5);
  testing::expect_in_support_at_the_edges<double>(flat, 0.5);
  testing::expect_in_support_at_the_edges<Packet>(flat, 0.5);
}

TEST(GaussianFilter, IsTheSameInPackets) {
  testing::expect_packets_like_double(half_pixel, 1.5, 1e-6, 3e-6);
  testing::expect_packets_like_double(longest, 2.5, 1e-6, 3e-6);
  testing::expect_packets_like_double(flat, 0.5, 1e-6, 3e-6);
}

RC_GTEST_PROP(GaussianFilter, HasTheJacobianOneOverItsDensity, ()) {
  const GaussianFilter<double> filter(1, 0.01 + 4.99 * *testing::unit_number());
  const Vec2<double> u = Vec2<double>::Constant(0.01) + 0.98 * *testing::unit_point();
  RC_ASSERT(testing::has_the_jacobian_one_over_its_density(filter, u, 1e-6));
}

TEST(GaussianFilter, RefusesWhatIsNoGaussian) {
  EXPECT_THROW(GaussianFilter<double>(0, 1), std::invalid_argument);
  EXPECT_THROW(GaussianFilter<double>(-1, 1), std::invalid_argument);
  EXPECT_THROW(GaussianFilter<double>(infinity<double>, 1), std::invalid_argument);
  EXPECT_THROW(GaussianFilter<double>(std::nan(""), 1), std::invalid_argument);
  EXPECT_THROW(GaussianFilter<double>(1, 0), std::invalid_argument);
  EXPECT_THROW(GaussianFilter<double>(1, std::nan("")), std::invalid_argument);
  EXPECT_THROW(GaussianFilter<double>(1, 5.01), std::invalid_argument);
  EXPECT_THROW(GaussianFilter<Packet>(Packet(1), Packet(6)), std::invalid_argument);
  EXPECT_THROW(GaussianFilter<float>(0.9e-6f, 1e-6f), std::invalid_argument);
  EXPECT_THROW(GaussianFilter<float>(1e-6f, 0.9e-6f), std::invalid_argument);
  EXPECT_THROW(GaussianFilter<float>(1.1e6f, 1), std::invalid_argument);
  EXPECT_LT(GaussianFilter<float>(1e-6f, 1e-6f).pdf({0, 0}).value(), INFINITY);
}

}  // namespace
}  // namespace fairlight

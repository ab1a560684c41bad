#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/filters.h>
#include <support/unit_square.h>

#include <fairlight/estimators/blackman_harris_filter.h>
#include <fairlight/estimators/concepts.h>

namespace fairlight {
namespace {

static_assert(Sampler<BlackmanHarrisFilter<double>>);

constexpr auto window = []<class Real>(std::type_identity<Real>) { return BlackmanHarrisFilter<Real>(Real(1.5)); };

// The window in Harris's form, divided by its integral.
double harris(double x, double radius) {
  const double t = M_PI * x / radius;
  return (0.35875 + 0.48829 * std::cos(t) + 0.14128 * std::cos(2 * t) + 0.01168 * std::cos(3 * t)) /
         (2 * 0.35875 * radius);
}

// The CDF of the window.
double below(double x, double radius) {
  const double t = M_PI * x / radius;
  return 0.5 +
         (0.35875 * t + 0.48829 * std::sin(t) + 0.14128 * std::sin(2 * t) / 2 + 0.01168 * std::sin(3 * t) / 3) /
             (2 * M_PI * 0.35875);
}

TEST(BlackmanHarrisFilter, IsOneOverTheWindowsMeanAtTheCentre) {
  const BlackmanHarrisFilter<double> filter(1);
  EXPECT_NEAR(filter.pdf({0, 0}).value(), std::pow(1 / (2 * 0.35875), 2), 1e-14);
  // At half the radius cos(t) = 0, cos(2t) = -1 and cos(3t) = 0: (0.35875 - 0.14128) / (2 0.35875).
  EXPECT_NEAR(filter.pdf({0.5, 0}).value(), 0.21747 / (2 * 0.35875) / (2 * 0.35875), 1e-14);
  EXPECT_EQ(filter.pdf({1.001, 0}).value(), 0);
  EXPECT_EQ(filter.pdf({0, -1.001}).value(), 0);
}

RC_GTEST_PROP(BlackmanHarrisFilter, IsTheWindow, ()) {
  const double radius = std::exp(std::log(1e-3) + std::log(1e8) * *testing::unit_number());
  const double x = radius * (2 * *testing::unit_number() - 1);
  const double expected = harris(x, radius) * harris(0, radius);
  RC_ASSERT(std::abs(BlackmanHarrisFilter<double>(radius).pdf({x, 0}).value() - expected) <=
            1e-14 / (radius * radius));
}

// To 4 ulp of 1, for numbers from all of [0,1) and for small ones down to 2^-53.
RC_GTEST_PROP(BlackmanHarrisFilter, InvertsItsDistributionFunctionToTheRounding, ()) {
  const double scale = std::pow(2.0, -*rc::gen::inRange(0, 53));
  const double u = scale * *testing::unit_number();
  const Vec2<double> x = BlackmanHarrisFilter<double>(2).sample({u, 1 - u});
  RC_ASSERT(std::abs(below(x.x(), 2) - u) <= 8 * 0x1p-53);
  RC_ASSERT(std::abs(below(x.y(), 2) - (1 - u)) <= 8 * 0x1p-53);
}

TEST(BlackmanHarrisFilter, StaysInItsDomainAtTheEdgesOfTheSquare) {
  testing::expect_in_support_at_the_edges<double>(window, 1.5);
  testing::expect_in_support_at_the_edges<float>(window, 1.5);
  testing::expect_in_support_at_the_edges<Packet>(window, 1.5);
  EXPECT_EQ(BlackmanHarrisFilter<double>(1.5).sample({0, 0.5}), Vec2<double>(-1.5, 0));
}

TEST(BlackmanHarrisFilter, IsTheSameInPackets) { testing::expect_packets_like_double(window, 1.5, 1e-6, 3e-6); }

RC_GTEST_PROP(BlackmanHarrisFilter, HasTheJacobianOneOverItsDensity, ()) {
  const Vec2<double> u = Vec2<double>::Constant(0.01) + 0.98 * *testing::unit_point();
  RC_ASSERT(testing::has_the_jacobian_one_over_its_density(BlackmanHarrisFilter<double>(2), u, 1e-6));
}

TEST(BlackmanHarrisFilter, RefusesARadiusThatIsNone) { testing::expect_radius_refused<BlackmanHarrisFilter>(); }

TEST(BlackmanHarrisFilter, RefusesARadiusThatFloatsDoNotHold) {
  for (float right : {1e-6f, 1e6f}) {
    const BlackmanHarrisFilter<float> filter(right);
    for (const Vec2<float>& u : testing::edge_points<float>()) {
      const auto density = static_cast<double>(filter.pdf(filter.sample(u)).value());
      EXPECT_TRUE(density > 0 && std::isfinite(density)) << right << ' ' << u.transpose();
    }
  }
  for (float wrong : {0.9e-6f, 1.1e6f}) EXPECT_THROW(BlackmanHarrisFilter<float>{wrong}, std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

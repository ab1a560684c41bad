#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/unit_square.h>

#include <fairlight/stats/rosenblatt.h>

namespace fairlight {
namespace {

const Trial trial{"rosenblatt", 1, 1e-6, 0.01, 0.05};

// p(s, t) = 4 s^3 (1 + (2s - 1)(2t - 1)): P(S <= s) = s^4, P(T <= t | s) = t + (2s - 1)(t^2 - t).
double density(double s, double t) { return 4 * s * s * s * (1 + (2 * s - 1) * (2 * t - 1)); }

RC_GTEST_PROP(Rosenblatt, IsTheConditionalDistributionFunctions, ()) {
  static const Rosenblatt transform(density);
  const Eigen::Vector2d x = *testing::unit_point();
  RC_PRE(x.x() > 1e-6);
  const Eigen::Vector2d u = transform(x.x(), x.y());
  RC_ASSERT(std::abs(u.x() - std::pow(x.x(), 4)) < 3e-11);  // at most 0.11 h^4, in the first slab
  RC_ASSERT(std::abs(u.y() - (x.y() + (2 * x.x() - 1) * (x.y() * x.y() - x.y()))) < 1e-12);
}

// No polynomial: exp(s t), over the sum of 1 / (n n!), has P(T <= t | s) = (exp(s t) - 1) / (exp(s) - 1).
RC_GTEST_PROP(Rosenblatt, IsTheConditionalLawOfWhatIsNoPolynomial, ()) {
  static const Rosenblatt transform([](double s, double t) { return std::exp(s * t) / 1.3179021514544038; });
  const Eigen::Vector2d x = *testing::unit_point();
  RC_PRE(x.x() > 1e-6);
  RC_ASSERT(std::abs(transform(x.x(), x.y()).y() - std::expm1(x.x() * x.y()) / std::expm1(x.x())) < 1e-12);
}

// A ridge that is narrower than a slab is no polynomial between its nodes. Its mass, 2e-7, is no matter.
TEST(Rosenblatt, LooksAgainWhereADensityIsNotSmooth) {
  const auto ridge = [](double s) { return 1 + std::exp(-std::pow(1e7 * (s - 0.5 - 0.5 / 256), 2)); };
  const Rosenblatt transform([&](double s, double t) { return 1 + (ridge(s) - 1) * 2 * t; });
  const double s = 0.5 + 0.5 / 256, t = 0.25;
  EXPECT_NEAR(transform(s, t).y(), (t + t * t) / 2, 1e-9);
}

TEST(Rosenblatt, IntegratesBetweenJumps) {
  const Rosenblatt transform([](double s, double) { return s < 0.1 ? 2.0 : s < 0.9 ? 0.5 : 4.0; });
  EXPECT_NEAR(transform(0.05, 0.5).x(), 0.1, 1e-6);
  EXPECT_NEAR(transform(0.5, 0.5).x(), 0.4, 1e-6);
  EXPECT_NEAR(transform(0.95, 0.5).x(), 0.8, 1e-6);
}

TEST(Rosenblatt, RefusesWhatCannotBeIntegrated) {
  const auto noise = [](double s, double) { return 2 * std::fmod(1e9 * s, 1.0); };
  EXPECT_THROW(Rosenblatt(noise, {.s = {}, .t = {}, .line = true}), CannotIntegrate);
}

TEST(Rosenblatt, RefusesADensityThatDoesNotIntegrateToOne) {
  EXPECT_THROW(Rosenblatt([](double, double) { return 1.1; }), std::invalid_argument);
}

// A lattice that fills the square evenly, in place of random numbers.
Eigen::Vector2d lattice(std::uint64_t i) {
  const auto n = static_cast<double>(i) + 0.5;
  return {std::fmod(n * 0.7548776662466927, 1.0), std::fmod(n * 0.5698402909980532, 1.0)};
}

TEST(RosenblattTest, CertifiesTheLawAndFindsAnother) {
  const auto ramp = [](double s, double) { return 2 * s; };
  const auto right = [](std::uint64_t i) { return Eigen::Vector2d(std::sqrt(lattice(i).x()), lattice(i).y()); };
  const auto wrong = [](std::uint64_t i) { return Eigen::Vector2d(std::pow(lattice(i).x(), 0.4), lattice(i).y()); };
  EXPECT_EQ(test_rosenblatt(trial, ramp, right).verdict, Verdict::certified);
  EXPECT_EQ(test_rosenblatt(trial, ramp, wrong).verdict, Verdict::biased);
  EXPECT_EQ(test_rosenblatt(trial, ramp, right).guarantee, Guarantee::exact);
  EXPECT_EQ(test_rosenblatt(trial, ramp, right).token, "0000000000000001");
}

// Of a place and its mirror image each has the uniform law.
TEST(RosenblattTest, TakesTheMeansOfReplicates) {
  const auto flat = [](double, double) { return 1.0; };
  const auto pair = [](std::uint64_t i) -> Eigen::Vector2d {
    return i % 2 == 0 ? lattice(i / 2) : Eigen::Vector2d(1, 1) - lattice(i / 2);
  };
  const auto crowded = [&](std::uint64_t i) { return Eigen::Vector2d(std::pow(pair(i).x(), 0.8), pair(i).y()); };
  const Finding found = test_rosenblatt(trial, flat, pair, 2);
  EXPECT_EQ(found.verdict, Verdict::certified);
  EXPECT_EQ(found.draws % 2, 0);
  EXPECT_EQ(test_rosenblatt(trial, flat, crowded, 2).verdict, Verdict::biased);
  EXPECT_THROW(test_rosenblatt(trial, flat, pair, 0), std::invalid_argument);
  const auto outside = [&](std::uint64_t i) -> Eigen::Vector2d {
    return i < 130 ? pair(i) : Eigen::Vector2d(0.5, -0.5);
  };
  EXPECT_EQ(test_rosenblatt(trial, flat, outside, 2).draws, 131u);
}

TEST(RosenblattTest, RefutesWhatIsNoDensityAndNoPoint) {
  const auto middle = [](std::uint64_t) { return Eigen::Vector2d(0.5, 0.5); };
  const auto too_much = [](double, double) { return 1.1; };
  EXPECT_NE(test_rosenblatt(trial, too_much, middle).note.find("integrates to 1.1"), std::string::npos);
  const auto flat = [](double, double) { return 1.0; };
  for (double wrong : {-0.1, 1.1, std::nan("")}) {
    const Finding finding =
        test_rosenblatt(trial, flat, [=](std::uint64_t) { return Eigen::Vector2d(0.5, wrong); });
    EXPECT_EQ(finding.verdict, Verdict::biased) << wrong;
    EXPECT_TRUE(finding.note.starts_with("draw 0 is ")) << finding.note;
  }
}

TEST(RosenblattTest, FindsADependenceBetweenTheAxes) {
  const auto flat = [](double, double) { return 1.0; };
  const auto diagonal = [](std::uint64_t i) {
    const Eigen::Vector2d x = lattice(i);
    return x.y() < 0.2 ? Eigen::Vector2d(x.x(), x.x()) : Eigen::Vector2d(x.x(), (x.y() - 0.2) / 0.8);
  };
  EXPECT_EQ(test_rosenblatt(trial, flat, diagonal).verdict, Verdict::biased);
}

}  // namespace
}  // namespace fairlight

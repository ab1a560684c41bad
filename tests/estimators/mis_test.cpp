#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/scripted_source.h>
#include <support/unit_square.h>

#include <fairlight/estimators/hemisphere.h>
#include <fairlight/estimators/mis.h>

namespace fairlight {
namespace {

using testing::ScriptedSource;

template <class Heuristic, class Real, std::size_t N>
std::array<Real, N> weights(const std::array<Real, N>& n, const std::array<Real, N>& densities) {
  const auto p = std::apply([](auto... x) { return std::array{Density<Area, Real>(x)...}; }, densities);
  std::array<Real, N> all;
  for (std::size_t i = 0; i < N; ++i) all[i] = Heuristic::weight(n, p, i);
  return all;
}

using Doubles = std::array<double, 2>;
const Doubles one_each{1, 1};

template <class Heuristic>
void expect_weights(const Doubles& n, const Doubles& p, const Doubles& expected) {
  const Doubles w = weights<Heuristic>(n, p);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_DOUBLE_EQ(w[i], expected[i]) << i;
}

TEST(BalanceHeuristic, IsInProportionToTheExpectedNumberOfDraws) {
  expect_weights<BalanceHeuristic>(one_each, {1, 3}, {0.25, 0.75});
  expect_weights<BalanceHeuristic>({6, 2}, {1, 1}, {0.75, 0.25});
}

TEST(PowerHeuristic, IsInProportionToItsSquare) {
  expect_weights<PowerHeuristic>({1, 3}, {1, 1}, {0.1, 0.9});
  expect_weights<PowerHeuristic>({3, 1}, {1, 9}, {0.1, 0.9});
}

TEST(MaximumHeuristic, GivesAllToTheLikeliestAndOfEqualsToTheFirst) {
  expect_weights<MaximumHeuristic>({1, 4}, {3, 1}, {0, 1});
  expect_weights<MaximumHeuristic>(one_each, {3, 1}, {1, 0});
  expect_weights<MaximumHeuristic>({2, 1}, {1, 2}, {1, 0});
}

// Densities of 10^(e/10); every third one is 0.
rc::Gen<double> density(int exponent) {
  return rc::gen::map(rc::gen::inRange(-10 * exponent, 10 * exponent + 1),
                      [](int e) { return e % 3 == 0 ? 0 : std::pow(10, e / 10.0); });
}

// Each of three weights is in [0,1], a law of density 0 has weight 0, and the weights sum to 1.
template <class Heuristic, class Real>
void expect_a_partition_of_one(int exponent) {
  std::array<Real, 3> n;
  std::array<Real, 3> p;
  for (std::size_t i = 0; i < 3; ++i) {
    n[i] = rounded<Real>(*rc::gen::inRange(1, 100));
    p[i] = rounded<Real>(*density(exponent));
  }
  const auto w = weights<Heuristic>(n, p);
  const Real none(0);
  for (std::size_t i = 0; i < 3; ++i) {
    RC_ASSERT(all(w[i] >= none) && all(w[i] <= Real(1)));
    if (all(p[i] == none)) RC_ASSERT(all(w[i] == none));
  }
  const Real expected = select(p[0] == none && p[1] == none && p[2] == none, none, Real(1));
  using std::abs;
  RC_ASSERT(all(abs(w[0] + w[1] + w[2] - expected) <= Real(8 * ulp<Real>)));
}

template <class Heuristic>
void expect_a_partition_of_one() {
  expect_a_partition_of_one<Heuristic, double>(300);
  expect_a_partition_of_one<Heuristic, float>(38);
  expect_a_partition_of_one<Heuristic, Packet>(38);
}

RC_GTEST_PROP(BalanceHeuristic, SumsToOne, ()) { expect_a_partition_of_one<BalanceHeuristic>(); }
RC_GTEST_PROP(PowerHeuristic, SumsToOne, ()) { expect_a_partition_of_one<PowerHeuristic>(); }
RC_GTEST_PROP(MaximumHeuristic, SumsToOne, ()) { expect_a_partition_of_one<MaximumHeuristic>(); }

TEST(PowerHeuristic, ReachesItsExcess) {
  const double two = 1 / (1 + std::sqrt(2.0));
  EXPECT_NEAR(weights<PowerHeuristic>(one_each, Doubles{1, two})[0] * (1 + two), PowerHeuristic::excess(2), 1e-15);
  const double four = 1.0 / 3;
  const auto w = weights<PowerHeuristic>(std::array{1.0, 1.0, 1.0, 1.0}, std::array{1.0, four, four, four});
  EXPECT_NEAR(w[0] * (1 + 3 * four), PowerHeuristic::excess(4), 1e-15);
}

TEST(MixtureBound, IsFlooredByTheBetterLaw) {
  EXPECT_EQ(mixture_bound<2>({1, 1}, {2, 2}), 2);
  EXPECT_EQ(mixture_bound<2>({1, 3}, {2, std::numeric_limits<double>::infinity()}), 8);
}

const auto laws = std::tuple(UniformHemisphere<double>{}, CosineHemisphere<double>{});
const auto height = [](const Vec3<double>& w) { return w.z(); };

TEST(MultiSampleMis, AddsTheDrawsOfEveryLaw) {
  // With the balance heuristic, a draw of height z contributes z / (1 / (2 pi) + 2 z / pi) = 2 pi z
  // / (1 + 4 z).
  const MultiSampleMis estimator(BalanceHeuristic{}, laws, {1, 2}, height, {0, 3});
  ScriptedSource source({0.5, 0, 0.75, 0, 0.9375, 0});  // heights 1/2; 1/2 and 1/4
  EXPECT_DOUBLE_EQ(estimator.estimate(source), 2 * M_PI * (0.5 / 3 + 0.5 / 3 + 0.25 / 2));
  EXPECT_TRUE(source.exhausted());
  EXPECT_EQ(estimator.bound(), (Bound{0, 3}));
}

TEST(OneSampleMis, DrawsFromTheLawThatIsChosen) {
  // With the maximum heuristic, uniform draws count below the height where 3/4 / (2 pi) = 1/4 z /
  // pi. That is z = 3/2, so they always count.
  const OneSampleMis estimator(MaximumHeuristic{}, laws, {3, 1}, height, {0, 3});
  ScriptedSource uniform({0.74, 0.5, 0});
  ScriptedSource cosine({0.75, 0.75, 0});
  EXPECT_DOUBLE_EQ(estimator.estimate(uniform), 0.5 * 2 * M_PI / 0.75);
  EXPECT_EQ(estimator.estimate(cosine), 0);
  EXPECT_TRUE(uniform.exhausted() && cosine.exhausted());
  EXPECT_EQ(estimator.bound(), (Bound{0, 6}));
}

TEST(OneSampleMis, ByTheBalanceHeuristicIsImportanceSamplingFromTheMixture) {
  const OneSampleMis estimator(BalanceHeuristic{}, laws, {1, 1}, height);
  for (const Vec2<double>& u : testing::edge_points()) {
    for (double choice : {0.0, 0.5, 1 - 0x1p-53}) {
      ScriptedSource source({choice, u.x(), u.y()});
      const double z = choice < 0.5 ? std::get<0>(laws).sample(u).z() : std::get<1>(laws).sample(u).z();
      EXPECT_NEAR(estimator.estimate(source), z / ((1 / (2 * M_PI) + z / M_PI) / 2), 1e-14);
    }
  }
}

// A law whose samples do not exist: their density is 0, and they contribute 0.
struct Nowhere {
  using Scalar = double;
  using Point = Vec3<double>;
  using Measure = SolidAngle;
  Point sample(const Vec2<double>&) const { return {0, 0, -1}; }
  Density<SolidAngle, double> pdf(const Point&) const { return Density<SolidAngle, double>(0); }
};

TEST(MultiSampleMis, CountsNothingForASampleThatDoesNotExist) {
  const MultiSampleMis estimator(PowerHeuristic{}, std::tuple(Nowhere{}, UniformHemisphere<double>{}), {1, 1},
                                 height);
  ScriptedSource source({0.5, 0, 0.5, 0});
  EXPECT_DOUBLE_EQ(estimator.estimate(source), 0.5 * 2 * M_PI);
}

TEST(MultiSampleMis, RefusesALawWithoutDraws) {
  EXPECT_THROW(MultiSampleMis(BalanceHeuristic{}, laws, {1, 0}, height), std::invalid_argument);
}

TEST(OneSampleMis, RefusesWhatIsNoProbability) {
  for (double c : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(OneSampleMis(BalanceHeuristic{}, laws, {1, c}, height), std::invalid_argument) << c;
  }
}

// Numbers that differ between lanes, and agree lane by lane with double.
struct Spread {
  double at;
  Packet next() {
    std::array<float, lanes<Packet>> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = float(number(i));
    advance();
    return Packet::load_unaligned(numbers.data());
  }
  double number(std::size_t lane) const { return std::fmod(at + 0.15625 * double(lane), 1); }
  void advance() { at = std::fmod(at + 0.34375, 1); }
};

struct OneLane {
  Spread spread;
  std::size_t lane;
  double next() {
    const double u = spread.number(lane);
    spread.advance();
    return u;
  }
};

template <class Make>
void expect_lanes_like_double(const Make& make) {
  for (double at : {0.0, 0.125, 0.625, 0.9375}) {
    Spread spread{at};
    std::array<double, lanes<Packet>> values{};
    store_lanes(make(Packet()).estimate(spread), values.data());
    for (std::size_t lane = 0; lane < lanes<Packet>; ++lane) {
      OneLane source{{at}, lane};
      const double expected = make(double()).estimate(source);
      EXPECT_LE(std::abs(values[lane] - expected), 2e-6 * (1 + expected)) << at << ", lane " << lane;
    }
  }
}

template <class Heuristic>
void expect_lanes_like_double() {
  expect_lanes_like_double([]<class Real>(Real) {
    return OneSampleMis(Heuristic{}, std::tuple(UniformHemisphere<Real>{}, CosineHemisphere<Real>{}), {1, 2},
                        [](const Vec3<Real>& w) { return w.z(); });
  });
  expect_lanes_like_double([]<class Real>(Real) {
    return MultiSampleMis(Heuristic{}, std::tuple(UniformHemisphere<Real>{}, CosineHemisphere<Real>{}), {1, 2},
                          [](const Vec3<Real>& w) { return w.z(); });
  });
}

TEST(OneSampleMis, ChoosesLaneByLane) {
  expect_lanes_like_double<BalanceHeuristic>();
  expect_lanes_like_double<PowerHeuristic>();
  expect_lanes_like_double<MaximumHeuristic>();
}

TEST(MisFactor, HidesNoDensityThatIsNotANumber) {
  using P = Density<Area, double>;
  const std::array<double, 2> n{1, 1};
  const std::array<P, 2> p{P(std::nan("")), P(1)};
  EXPECT_TRUE(std::isnan(mis_factor<BalanceHeuristic>(n, p, 0)));
  EXPECT_TRUE(std::isnan(mis_factor<PowerHeuristic>(n, p, 0)));
  EXPECT_TRUE(std::isnan(mis_factor<MaximumHeuristic>(n, p, 0)));
  EXPECT_TRUE(std::isnan(mis_factor<BalanceHeuristic>(n, p, 1)));
}

}  // namespace
}  // namespace fairlight

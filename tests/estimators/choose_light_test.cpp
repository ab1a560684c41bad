#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/lights.h>
#include <support/scripted_source.h>
#include <support/unit_square.h>

#include <fairlight/estimators/choose_light.h>

namespace fairlight {
namespace {

using testing::first_lane;
using testing::ScriptedSource;

const std::vector<double> powers{0, 1, 0, 2, 5, 0};

// Weights like `powers`, given by a function as at a point.
double power(int i) { return powers[static_cast<std::size_t>(i)]; }
const ContributionChoice<double, double (*)(int)> by_contribution(6, power);
const PowerChoice<double> by_power(powers);

template <class Choice>
void expect_eighths(const Choice& choice) {
  EXPECT_EQ(choice.sample({0, 0}).index, 1);
  EXPECT_EQ(choice.sample({0.124, 0.9}).index, 1);
  EXPECT_EQ(choice.sample({0.125, 0}).index, 3);
  EXPECT_EQ(choice.sample({0.375, 0}).index, 4);
  EXPECT_EQ(choice.sample({1 - 0x1p-53, 1 - 0x1p-53}).index, 4);
  EXPECT_EQ(choice.sample({0.1, 0}).probability.value(), 0.125);
  EXPECT_EQ(choice.sample({0.9, 0}).probability.value(), 0.625);
}

TEST(PowerChoice, CutsTheUnitIntervalInProportion) { expect_eighths(by_power); }
TEST(ContributionChoice, CutsTheUnitIntervalInProportion) { expect_eighths(by_contribution); }

// A common factor of the weights does not change the choice.
TEST(ContributionChoice, KnowsNoScaleOfItsWeights) {
  for (const int exponent : {-60, 60}) {
    const auto scaled = [exponent](int i) { return std::ldexp(power(i), exponent); };
    const ContributionChoice<double, decltype(scaled)> choice(6, scaled);
    EXPECT_EQ(choice.probability(3), 0.25);
    EXPECT_EQ(choice.sample({0.2, 0}).index, 3);
    EXPECT_EQ(choice.sample({0.2, 0}).probability.value(), 0.25);
  }
}

template <class Choice>
void expect_nothing(const Choice& choice) {
  EXPECT_EQ(choice.sample({0.5, 0.5}).probability.value(), 0);
  ScriptedSource source({0.5, 0.5});
  const auto no_term = [](int, ScriptedSource&) -> double { throw std::logic_error("nothing was to be chosen"); };
  EXPECT_EQ(LightSampler(choice).template sum<double>(choice.size(), source, no_term), 0);
}

TEST(PowerChoice, ChoosesNothingAmongNothingOrWhereNothingHasPower) {
  expect_nothing(PowerChoice<double>(std::vector<double>{}));
  expect_nothing(PowerChoice<double>(std::vector<double>{0, 0, 0}));
}

TEST(ContributionChoice, ChoosesNothingAmongNothingOrWhereNothingContributes) {
  expect_nothing(ContributionChoice<double, double (*)(int)>(0, power));
  expect_nothing(ContributionChoice<double, double (*)(int)>(1, power));
}

TEST(PowerChoice, RefusesWhatIsNoWeight) {
  for (double wrong : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(PowerChoice<double>(std::vector<double>{1, wrong}), std::invalid_argument);
  }
}

TEST(ContributionChoice, RefusesWhatIsNoWeight) {
  const auto negative = [](int i) { return i - 1.0; };
  EXPECT_THROW((ContributionChoice<double, decltype(negative)>(3, negative).sample({0.5, 0})),
               std::invalid_argument);
  EXPECT_THROW((ContributionChoice<double, decltype(negative)>(-1, negative)), std::invalid_argument);
}

// n weights: every third is 0, the others cycle through 1 .. 7. Below n = 3 all are 0 except the
// last.
std::vector<double> weights(int n) {
  std::vector<double> all(static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i % 3 == 2 ? 0 : static_cast<double>(i % 7 + 1);
  return all;
}

RC_GTEST_PROP(PowerChoice, IsTheInverseOfTheCumulativeWeights, ()) {
  const int n = *rc::gen::inRange(1, 100001);
  const std::vector<double> all = weights(n);
  const Vec2<double> u = *testing::unit_point();
  const PowerChoice<double> choice(all);
  const auto pick = choice.sample(u);
  const auto chosen = static_cast<std::size_t>(pick.index);
  RC_ASSERT(chosen < all.size());
  double total = 0, below = 0;
  for (std::size_t i = 0; i < all.size(); ++i) (i < chosen ? below : total) += all[i];
  total += below;
  RC_ASSERT(all[chosen] > 0);
  RC_ASSERT(std::abs(pick.probability.value() - all[chosen] / total) <= 1e-15);
  RC_ASSERT(below / total <= u.x() + 1e-15 && u.x() <= (below + all[chosen]) / total + 1e-15);
  const auto weight = [&](int i) { return all[static_cast<std::size_t>(i)]; };
  const auto again = ContributionChoice<double, decltype(weight)>(n, weight).sample(u);
  RC_ASSERT(again.index == pick.index || std::abs(below / total - u.x()) < 1e-15 ||
            std::abs((below + all[chosen]) / total - u.x()) < 1e-15);
}

// In packets the boundary between two alternatives is exact to 2^-48.
TEST(PowerChoice, ChoosesFinelyInPackets) {
  const std::vector<double> equal(100000, 3.0);
  const auto constant = [](int) { return Packet(3.0f); };
  const PowerChoice<Packet> power_choice(equal);
  const ContributionChoice<Packet, decltype(constant)> contribution_choice(100000, constant);
  const auto expect = [&](float x, float y, int index) {
    const Vec2<Packet> u{Packet(x), Packet(y)};
    EXPECT_EQ(first_lane(xsimd::to_float(power_choice.sample(u).index)), index);
    EXPECT_EQ(first_lane(xsimd::to_float(contribution_choice.sample(u).index)), index);
    EXPECT_FLOAT_EQ(static_cast<float>(first_lane(power_choice.sample(u).probability.value())), 1e-5f);
  };
  expect(167 * 0x1p-24f, 0.7721f, 0);
  expect(167 * 0x1p-24f, 0.7722f, 1);
  expect(0, 0, 0);
  expect(1 - 0x1p-24f, 1 - 0x1p-24f, 99999);
}

TEST(PowerChoice, ChoosesLaneByLane) {
  alignas(64) std::array<float, lanes<Packet>> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = static_cast<float>(i) / static_cast<float>(numbers.size());
  const auto pick = PowerChoice<Packet>(powers).sample({Packet::load_unaligned(numbers.data()), Packet(0.0f)});
  std::array<double, lanes<Packet>> indices{}, probabilities{};
  store_lanes(xsimd::to_float(pick.index), indices.data());
  store_lanes(pick.probability.value(), probabilities.data());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto one = by_power.sample({static_cast<double>(numbers[i]), 0});
    EXPECT_EQ(indices[i], one.index);
    EXPECT_EQ(probabilities[i], one.probability.value());
  }
}

// 10^5 lights of weight 0.1, whose plain sum in floats has an error of 1 %. Bisection over 48 bits
// finds the boundaries between lights.
TEST(ContributionChoice, GivesInFloatsTheProbabilityWithWhichItChooses) {
  constexpr int n = 100'000;
  const auto tenth = [](int) { return 0.1f; };
  const ContributionChoice<float, decltype(tenth)> choice(n, tenth);
  const auto sample = [&](std::uint64_t u) {
    return choice.sample({static_cast<float>(u >> 24) * 0x1p-24f, static_cast<float>(u & 0xFFFFFF) * 0x1p-24f});
  };
  const auto begin = [&](int light) {
    std::uint64_t below = 0, reached = std::uint64_t{1} << 48;
    while (reached - below > 1) {
      const std::uint64_t middle = (below + reached) / 2;
      (sample(middle).index < light ? below : reached) = middle;
    }
    return static_cast<double>(reached) * 0x1p-48;
  };
  const double given = sample(0).probability.value();
  EXPECT_NEAR(given, 1e-5, 1e-5 * (n * 0x1p-24 * n * 0x1p-24));
  const double exact = (n + 1) * 0x1p-46 + given * 0x1p-24;
  for (int light : {1, 33'333, 99'998}) EXPECT_NEAR(begin(light + 1) - begin(light), given, exact) << light;
  EXPECT_NEAR(1 - begin(n - 1), given, exact);
}

// A weight that differs between lanes, and a light of weight 0 in half of them.
TEST(ContributionChoice, ChoosesLaneByLane) {
  std::array<float, lanes<Packet>> places{}, numbers{};
  for (std::size_t i = 0; i < lanes<Packet>; ++i) {
    places[i] = static_cast<float>(i);
    numbers[i] = (static_cast<float>(i) + 0.5f) / static_cast<float>(lanes<Packet>);
  }
  const auto weights_at = []<class Real>(Real place) {
    return [place](int i) {
      const Real away = place - rounded<Real>(3 * i);
      const Real weight = rounded<Real>(powers[static_cast<std::size_t>(i)]) / (Real(1) + away * away);
      return Real(select(i == 1 ? place > Real(2) : place < Real(0), Real(0), weight));
    };
  };
  const auto weight = weights_at(Packet::load_unaligned(places.data()));
  const ContributionChoice<Packet, decltype(weight)> packets(6, weight);
  const auto pick = packets.sample({Packet::load_unaligned(numbers.data()), Packet(0.5f)});
  std::array<double, lanes<Packet>> indices{}, probabilities{};
  store_lanes(xsimd::to_float(pick.index), indices.data());
  store_lanes(pick.probability.value(), probabilities.data());
  for (std::size_t i = 0; i < lanes<Packet>; ++i) {
    const auto one_weight = weights_at(static_cast<double>(places[i]));
    const ContributionChoice<double, decltype(one_weight)> alone(6, one_weight);
    const auto one = alone.sample({static_cast<double>(numbers[i]), 0.5});
    EXPECT_EQ(indices[i], one.index) << i;
    EXPECT_NEAR(probabilities[i], one.probability.value(), 4 * ulp<float>) << i;
  }
}

TEST(ContributionChoice, RefusesWhatIsNoWeightInAnyLane) {
  std::array<float, lanes<Packet>> weights{};
  for (float wrong : {-1.0f, std::nanf(""), infinity<float>}) {
    weights.fill(1);
    weights.back() = wrong;
    const auto weight = [&](int) { return Packet::load_unaligned(weights.data()); };
    const ContributionChoice<Packet, decltype(weight)> choice(2, weight);
    EXPECT_THROW(choice.sample({Packet(0.5f), Packet(0.5f)}), std::invalid_argument) << wrong;
  }
}

TEST(LightSampler, DividesTheTermByItsProbability) {
  ScriptedSource source({0.5, 0, 0.25});
  const auto term = [](int i, ScriptedSource& numbers) { return i * numbers.next(); };
  EXPECT_EQ(LightSampler(by_power).sum<double>(6, source, term), 4 * 0.25 / 0.625);
  EXPECT_TRUE(source.exhausted());
}

// A value in [2, 4] with probability 1/4, -3 with probability 3/4. An alternative that is never
// chosen does not affect the bound.
TEST(LightSampler, LiesWithinTheHullOfTheBoundsOverTheirProbabilities) {
  using One = LightSampler<PowerChoice<double>>;
  const std::vector<Bound> terms{{2, 4}, {-3, -3}, {}};
  const std::vector<double> probabilities{0.25, 0.75, 0};
  EXPECT_EQ(One::bound(terms, probabilities), (Bound{-4, 16}));
  EXPECT_EQ(One::bound(terms, std::vector<double>(3, 0)), (Bound{0, 0}));
  EXPECT_EQ(One::bound({}, {}), (Bound{0, 0}));
  EXPECT_THROW(One::bound(terms, std::vector<double>(2, 0.5)), std::invalid_argument);
  EXPECT_THROW(One::bound(terms, std::vector<double>{0.5, 0.5, std::nan("")}), std::invalid_argument);
}

TEST(LightSampler, RefusesAnotherNumberOfTerms) {
  ScriptedSource source({0.5, 0, 0.25});
  const auto term = [](int, ScriptedSource&) { return 1.0; };
  EXPECT_THROW(LightSampler(by_power).sum<double>(5, source, term), std::invalid_argument);
}

TEST(PowerChoice, RefusesWeightsWhoseSumIsNotFinite) {
  EXPECT_THROW(PowerChoice<double>({1e308, 1e308}), std::invalid_argument);
}

// A negative or NaN density does not count as "sample does not exist".
TEST(SafeDivide, GivesNothingForADensityOfZeroAndHidesNoOther) {
  using P = Density<Area, double>;
  EXPECT_EQ(safe_divide(3.0, P(0)), 0);
  EXPECT_EQ(safe_divide(3.0, P(2)), 1.5);
  EXPECT_EQ(safe_divide(3.0, P(-2)), -1.5);
  EXPECT_TRUE(std::isnan(safe_divide(3.0, P(std::nan("")))));
}

}  // namespace
}  // namespace fairlight

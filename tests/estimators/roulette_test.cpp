#include <array>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>
#include <support/scripted_source.h>
#include <support/unit_square.h>

#include <fairlight/estimators/roulette.h>

namespace fairlight {
namespace {

using testing::lanes_of;
using testing::ScriptedSource;

TEST(RussianRoulette, PaysSurvivorsTheInverseOfTheirProbability) {
  EXPECT_TRUE(RussianRoulette::play(0.25, 0.2).alive);
  EXPECT_EQ(RussianRoulette::play(0.25, 0.2).weight, 4);
  EXPECT_FALSE(RussianRoulette::play(0.25, 0.25).alive);
}

TEST(RussianRoulette, NeverSurvivesZeroAndAlwaysSurvivesOne) {
  EXPECT_FALSE(RussianRoulette::play(0.0, 0.0).alive);
  EXPECT_TRUE(RussianRoulette::play(1.0, 1 - 0x1p-53).alive);
}

// Of all numbers on a grid as many survive as the probability says, each is paid the same, and all
// together what they were. Each probability is a multiple of the grid's step, so the count is
// exact; the pay is rounded once.
template <class Real>
void expect_mean_kept() {
  constexpr int grid = 256;
  for (const int part : {1, 2, 85, 128, 255, 256}) {
    std::array<int, lanes<Real>> survivors{};
    for (int i = 0; i < grid; ++i) {
      const auto [alive, weight] = RussianRoulette::play(rounded<Real>(part / 256.0), rounded<Real>(i / 256.0));
      const auto paid = lanes_of(Real(select(alive, weight, Real(0))));
      for (std::size_t lane = 0; lane < lanes<Real>; ++lane) {
        if (paid[lane] == 0) continue;
        ++survivors[lane];
        EXPECT_NEAR(part * paid[lane], grid, grid * static_cast<double>(ulp<Real>)) << part << ", lane " << lane;
      }
    }
    for (const int count : survivors) EXPECT_EQ(count, part);
  }
}

TEST(RussianRoulette, LeavesTheMeanAsItWas) {
  expect_mean_kept<double>();
  expect_mean_kept<Packet>();
}

struct Two {
  using Scalar = double;
  double estimate(ScriptedSource&) const { return 2; }
  Bound bound() const { return {2, 2}; }
};

TEST(Rouletted, IsTheEstimatorOverQOrNothing) {
  const Rouletted estimator(Two{}, 0.5);
  ScriptedSource survives({0.4});
  ScriptedSource dies({0.6});
  EXPECT_EQ(estimator.estimate(survives), 4);
  EXPECT_EQ(estimator.estimate(dies), 0);
  EXPECT_EQ(estimator.bound(), (Bound{0, 4}));
}

TEST(Rouletted, RefusesWhatIsNoProbability) {
  for (double q : {0.0, -0.5, 1.5, std::nan("")}) EXPECT_THROW(Rouletted(Two{}, q), std::invalid_argument) << q;
}

const Rgb<double> throughput(0.5, 0.125, 0.25);

TEST(RouletteByReflectance, GoesOnWithTheLargestReflectance) {
  const Rgb<double> albedo(0.25, 0.5, 0.125);
  ScriptedSource below({0.49});
  ScriptedSource above({0.51});
  EXPECT_TRUE(RouletteByReflectance<>::play<double>(albedo, throughput, 0, below).alive);
  EXPECT_FALSE(RouletteByReflectance<>::play<double>(albedo, throughput, 0, above).alive);
}

TEST(RouletteByThroughput, GoesOnWithTheLargestChannelOfWhatTheBounceLeaves) {
  const Rgb<double> albedo(0.25, 0.5, 1);  // leaves 1/8, 1/16, 1/4
  ScriptedSource below({0.24});
  ScriptedSource above({0.26});
  const auto survival = RouletteByThroughput<>::play<double>(albedo, throughput, 0, below);
  EXPECT_TRUE(survival.alive);
  EXPECT_EQ(survival.weight, 4);
  EXPECT_FALSE(RouletteByThroughput<>::play<double>(albedo, throughput, 0, above).alive);
}

TEST(RouletteByThroughput, NeverEndsAPathThatWillCarryOneOrMore) {
  ScriptedSource largest({1 - 0x1p-53});
  const auto survival =
      RouletteByThroughput<>::play<double>(Rgb<double>(0.5, 0.5, 0.5), Rgb<double>(0.5, 3, 1), 0, largest);
  EXPECT_TRUE(survival.alive);
  EXPECT_EQ(survival.weight, 1);
}

TEST(RouletteFromBounce, WaitsForItsBounce) {
  const RouletteFromBounce<RouletteByThroughput<>> from_second(2);
  ScriptedSource two({0.26, 0.26});
  const Rgb<double> half(0.5, 0.5, 0.5);
  const auto first = from_second.play<double>(half, half, 0, two);
  EXPECT_TRUE(first.alive);
  EXPECT_EQ(first.weight, 1);
  EXPECT_FALSE(from_second.play<double>(half, half, 1, two).alive);
  EXPECT_TRUE(two.exhausted());
}

// Of two lanes that draw the same number, 0.6 against 1/2, one is at its first bounce, and is not paid either.
TEST(RouletteFromBounce, SparesLaneByLane) {
  struct Constant {
    Packet next() const { return Packet(0.6f); }
  } constant;
  std::array<double, lanes<Packet>> depths{}, alive{}, weights{};
  depths[1] = 1;
  Packet depth;
  load_lanes(depths.data(), depth);
  const Rgb<Packet> one = Rgb<Packet>::Ones(), half = Rgb<Packet>::Constant(Packet(0.5f));
  const auto survival = RouletteFromBounce<RouletteByThroughput<>>(2).play<Packet>(half, one, depth, constant);
  store_lanes(Packet(select(survival.alive, Packet(1.0f), Packet(0.0f))), alive.data());
  store_lanes(survival.weight, weights.data());
  EXPECT_EQ(alive[0], 1);
  EXPECT_EQ(weights[0], 1);
  EXPECT_EQ(alive[1], 0);
}

TEST(RouletteFromBounce, RefusesToBeginBeforeTheFirst) {
  for (int first : {0, -3}) {
    EXPECT_THROW(RouletteFromBounce<RouletteByReflectance<>>{first}, std::invalid_argument) << first;
  }
}

TEST(NoRoulette, AlwaysGoesOnAndTakesNoNumber) {
  ScriptedSource none({});
  const auto survival = NoRoulette::play<double>(Rgb<double>::Zero(), Rgb<double>::Zero(), 5, none);
  EXPECT_TRUE(survival.alive);
  EXPECT_EQ(survival.weight, 1);
}

// The lanes of a packet play for themselves.
TEST(RouletteByThroughput, PlaysLaneByLane) {
  struct Ramp {
    Packet next() const {
      std::array<float, lanes<Packet>> numbers{};
      for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = float(i) / float(numbers.size());
      return Packet::load_unaligned(numbers.data());
    }
  } ramp;
  const Rgb<Packet> one = Rgb<Packet>::Ones(), half = Rgb<Packet>::Constant(Packet(0.5f));
  const auto [alive, weight] = RouletteByThroughput<>::play<Packet>(half, one, 0, ramp);
  std::array<double, lanes<Packet>> values{};
  store_lanes(Packet(select(alive, weight, Packet(0.0f))), values.data());
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(values[i], 2 * i < values.size() ? 2 : 0) << i;
}

TEST(RussianRoulette, RefusesWhatIsNoProbability) {
  for (double q : {-0.5, 1.5, std::nan("")}) {
    EXPECT_THROW(RussianRoulette::play<double>(q, 0.5), std::invalid_argument) << q;
    std::array<float, lanes<Packet>> lane{};
    lane.back() = static_cast<float>(q);
    EXPECT_THROW(RussianRoulette::play<Packet>(Packet::load_unaligned(lane.data()), Packet(0.5f)),
                 std::invalid_argument)
        << q;
  }
}

}  // namespace
}  // namespace fairlight

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/scripted_source.h>
#include <support/unit_square.h>

#include <fairlight/estimators/roulette.h>

namespace fairlight {
namespace {

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

// The mean over the two outcomes is what it was: q times 1/q.
RC_GTEST_PROP(RussianRoulette, LeavesTheMeanAsItWas, ()) {
  const double q = *testing::unit_number();
  RC_PRE(q > 0);
  RC_ASSERT(std::abs(q * RussianRoulette::play(q, 0.0).weight - 1) <= 1e-15);
}

struct Two {
  double estimate(ScriptedSource&) const { return 2; }
};

TEST(Rouletted, IsTheEstimatorOverQOrNothing) {
  const Rouletted<Two, double> estimator(Two{}, 0.5);
  ScriptedSource survives({0.4});
  ScriptedSource dies({0.6});
  EXPECT_EQ(estimator.estimate(survives), 4);
  EXPECT_EQ(estimator.estimate(dies), 0);
}

TEST(RouletteByReflectance, GoesOnWithTheLargestReflectance) {
  const Rgb<double> albedo(0.25, 0.5, 0.125);
  ScriptedSource below({0.49});
  ScriptedSource above({0.51});
  EXPECT_TRUE(RouletteByReflectance<>::play<double>(albedo, below).alive);
  EXPECT_FALSE(RouletteByReflectance<>::play<double>(albedo, above).alive);
}

TEST(NoRoulette, AlwaysGoesOnAndTakesNoNumber) {
  ScriptedSource none({});
  const auto survival = NoRoulette::play<double>(Rgb<double>::Zero(), none);
  EXPECT_TRUE(survival.alive);
  EXPECT_EQ(survival.weight, 1);
}

}  // namespace
}  // namespace fairlight

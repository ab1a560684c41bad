#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/lights.h>
#include <support/scripted_source.h>
#include <support/unit_square.h>

#include <fairlight/estimators/pick_one.h>

namespace fairlight {
namespace {

using testing::ScriptedSource;

TEST(UniformChoice, CutsTheUnitIntervalIntoEqualParts) {
  const UniformChoice<double> choice(4);
  EXPECT_EQ(choice.sample({0, 0}).index, 0);
  EXPECT_EQ(choice.sample({0.25, 0}).index, 1);
  EXPECT_EQ(choice.sample({0.999, 0}).index, 3);
  EXPECT_EQ(choice.sample({0.5, 0}).probability.value(), 0.25);
}

RC_GTEST_PROP(UniformChoice, NamesAnAlternativeThatExists, ()) {
  const int n = *rc::gen::inRange(1, 100001);
  const UniformChoice<double> choice(n);
  const Vec2<double> u = *testing::unit_point();
  RC_ASSERT(choice.sample(u).index >= 0);
  RC_ASSERT(choice.sample(u).index < n);
  RC_ASSERT(choice.sample(Vec2<double>::Constant(1 - 0x1p-53)).index == n - 1);
}

// Between neighbours of 24 bits the second number decides: 100000 x / 2^24 passes 1 at x =
// 167.77216.
TEST(UniformChoice, ChoosesFinelyInPackets) {
  const UniformChoice<Packet> choice(100000);
  const auto index = [&](float x, float y) {
    return testing::first_lane(xsimd::to_float(choice.sample({Packet(x), Packet(y)}).index));
  };
  EXPECT_EQ(index(167 * 0x1p-24f, 0.7721f), 0);
  EXPECT_EQ(index(167 * 0x1p-24f, 0.7722f), 1);
  EXPECT_EQ(index(1 - 0x1p-24f, 1 - 0x1p-24f), 99999);
}

// The integer part of n (a 2^24 + b) / 2^48, in integers; a and b are the first 24 bits of the two
// numbers.
RC_GTEST_PROP(UniformChoice, IsTheWholePartOfTheProductInEveryArithmetic, ()) {
  const auto n = *rc::gen::element<std::uint64_t>(1, 3, 1000, 100'000, (1 << 24) - 1, 1 << 24);
  const auto bits = rc::gen::inRange<std::uint64_t>(0, 1 << 24);
  const auto edge = rc::gen::element<std::uint64_t>(0, 1, (1 << 24) - 1);
  const auto a = *rc::gen::oneOf(bits, edge), b = *rc::gen::oneOf(bits, edge);
  const auto expected = static_cast<int>((a * n + (b * n >> 24)) >> 24);
  const float x = static_cast<float>(a) * 0x1p-24f, y = static_cast<float>(b) * 0x1p-24f;
  const int among = static_cast<int>(n);
  RC_ASSERT(UniformChoice<double>(among).sample({x, y}).index == expected);
  RC_ASSERT(UniformChoice<float>(among).sample({x, y}).index == expected);
  const auto pick = UniformChoice<Packet>(among).sample({Packet(x), Packet(y)});
  RC_ASSERT(testing::first_lane(xsimd::to_float(pick.index)) == expected);
  RC_ASSERT(testing::first_lane(pick.probability.value()) == 1.0f / static_cast<float>(n));
}

TEST(UniformChoice, RefusesNoAlternativesAndMoreThanAFloatCounts) {
  EXPECT_THROW(UniformChoice<double>(0), std::invalid_argument);
  EXPECT_THROW(UniformChoice<double>(-1), std::invalid_argument);
  EXPECT_THROW(UniformChoice<double>((1 << 24) + 1), std::invalid_argument);
}

double term(int i, ScriptedSource& source) { return (i + 1) * source.next(); }

TEST(AllLights, AddsEveryTerm) {
  ScriptedSource source({0.5, 0.25, 0.125});
  EXPECT_EQ(AllLights::sum<double>(3, source, term), 0.5 + 2 * 0.25 + 3 * 0.125);
  EXPECT_TRUE(source.exhausted());
}

TEST(UniformLightSampler, WeightsTheTermByTheirNumber) {
  ScriptedSource source({0.5, 0, 0.25});
  EXPECT_EQ(UniformLightSampler::sum<double>(3, source, term), 3 * 2 * 0.25);
  EXPECT_TRUE(source.exhausted());
}

TEST(AllLights, LiesWithinTheSumOfTheBounds) {
  const std::vector<Bound> terms{{0, 2}, {-1, 3}};
  EXPECT_EQ(AllLights::bound(terms), (Bound{-1, 5}));
  EXPECT_EQ(AllLights::bound({}), (Bound{0, 0}));
}

TEST(UniformLightSampler, LiesWithinTheirNumberTimesTheHull) {
  const std::vector<Bound> terms{{1, 2}, {-1, 3}, {2, 2}};
  EXPECT_EQ(UniformLightSampler::bound(terms), (Bound{-3, 9}));
  EXPECT_EQ(UniformLightSampler::bound({}), (Bound{0, 0}));
}

TEST(SumOfNothing, IsZero) {
  ScriptedSource none({});
  EXPECT_EQ(AllLights::sum<double>(0, none, term), 0);
  EXPECT_EQ(UniformLightSampler::sum<double>(0, none, term), 0);
}

}  // namespace
}  // namespace fairlight

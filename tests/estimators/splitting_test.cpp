#include <array>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/next_number.h>
#include <support/scripted_source.h>

#include <fairlight/estimators/splitting.h>
#include <fairlight/estimators/stream.h>

namespace fairlight {
namespace {

using testing::NextNumber;
using testing::ScriptedSource;

TEST(Splitting, IsTheMeanOfItsRuns) {
  ScriptedSource source({0.25, 0.5, 0.75, 0.5});
  EXPECT_EQ(Splitting(NextNumber<double>{}, 4).estimate(source), 0.5);
  EXPECT_TRUE(source.exhausted());
}

TEST(Splitting, RunsOnceMoreWithTheFractionForAProbability) {
  const Splitting estimator(NextNumber<double>{}, 2.5);
  ScriptedSource twice({0.5, 0.25, 0.75});
  EXPECT_EQ(estimator.estimate(twice), 1 / 2.5);
  EXPECT_TRUE(twice.exhausted());
  ScriptedSource thrice({0.49, 0.25, 0.75, 0.5});
  EXPECT_EQ(estimator.estimate(thrice), 1.5 / 2.5);
  EXPECT_TRUE(thrice.exhausted());
}

TEST(Splitting, IsRouletteBelowOne) {
  const Splitting estimator(NextNumber<double>{}, 0.25);
  ScriptedSource runs({0.24, 0.5});
  ScriptedSource dies({0.25});
  EXPECT_EQ(estimator.estimate(runs), 2);
  EXPECT_EQ(estimator.estimate(dies), 0);
}

TEST(Splitting, DeclaresItsBound) {
  EXPECT_EQ(Splitting(NextNumber<double>{3}, 4).bound(), (Bound{0, 3}));
  EXPECT_EQ(Splitting(NextNumber<double>{3}, 2.5).bound(), (Bound{0, 3 * 3 / 2.5}));
  EXPECT_EQ(Splitting(NextNumber<double>{3}, 0.25).bound(), (Bound{0, 12}));
}

// All runs give the same value. The two outcomes, weighted by their probabilities, give it back.
RC_GTEST_PROP(Splitting, LeavesTheMeanAsItWas, ()) {
  const double k = *rc::gen::inRange(1, 10'000) * 1e-3;
  const Splitting estimator(NextNumber<double>{}, k);
  const double fraction = k - std::floor(k);
  const std::vector<double> ones(12, 1);
  std::vector<double> more = ones;
  more[0] = 0;
  ScriptedSource floor_runs(ones);
  ScriptedSource ceiling_runs(more);
  const double mean =
      fraction == 0 ? estimator.estimate(floor_runs)
                    : fraction * estimator.estimate(ceiling_runs) + (1 - fraction) * estimator.estimate(floor_runs);
  RC_ASSERT(std::abs(mean - 1) <= 1e-14);
}

TEST(Splitting, RefusesANumberOfRunsThatIsNotPositive) {
  for (double k : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(Splitting(NextNumber<double>{}, k), std::invalid_argument) << k;
  }
}

// Each lane agrees with double for the same numbers.
TEST(Splitting, SplitsLaneByLane) {
  const StreamKey key(1, "splitting");
  PhiloxStream<Packet> packets(key, 0, 0);
  PhiloxStream<Packet> again(key, 0, 0);
  std::array<double, lanes<Packet>> values{};
  store_lanes(Splitting(NextNumber<Packet>{}, 2.5).estimate(packets), values.data());
  std::array<std::array<double, lanes<Packet>>, 4> numbers{};
  for (auto& number : numbers) store_lanes(again.next(), number.data());
  for (std::size_t lane = 0; lane < lanes<Packet>; ++lane) {
    ScriptedSource source({numbers[0][lane], numbers[1][lane], numbers[2][lane], numbers[3][lane]});
    const double expected = Splitting(NextNumber<double>{}, 2.5).estimate(source);
    EXPECT_LE(std::abs(values[lane] - expected), 4 * static_cast<double>(ulp<float>) * expected) << lane;
  }
}

}  // namespace
}  // namespace fairlight

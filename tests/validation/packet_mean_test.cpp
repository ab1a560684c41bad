#include <cmath>
#include <limits>
#include <map>
#include <memory>

#include <gtest/gtest.h>
#include <support/run_seed.h>

#include <fairlight/validation/checks/means.h>

namespace fairlight {
namespace {

Trial at_margin(double margin) { return {"packet_mean_test", testing::run_seed(), 1e-6, 0.01, margin}; }
const std::vector<Reference> two{{2, 0, 4}};
constexpr double some = 1e5;  // draws

// `draw(source)`, in packets.
template <class Draw>
Draws packet_draws(const Draw& draw) {
  return draws_of<Packet>(body_of_source<Packet>(draw), 1);
}

// So many ramps of 2u + 1 in a row, whose mean is 2, off by so much.
Draws ramps(float count, double bias = 0) {
  return packet_draws([=](auto& source) {
    using std::floor;
    const Packet place = Packet(count) * source.next();
    return Packet((Packet(2) * (place - floor(place)) + Packet(1)) * rounded<Packet>(1 + bias));
  });
}

// What pilots choose with most of 33 seeds. A pilot of 64 draws knows a variance to a fifth, so one alone may err.
std::uint32_t points_mostly(double margin, const std::vector<Reference>& references, const Draws& draws,
                            double many) {
  std::map<std::uint32_t, int> chosen;
  for (std::uint64_t i = 0; i < 33; ++i) {
    Trial trial = at_margin(margin);
    trial.seed += i;
    const SamplingScheme scheme = PacketMean(trial, references, draws).cheapest(many);
    if (++chosen[scheme.points] > 16) return scheme.points;
  }
  ADD_FAILURE() << "no choice of most";
  return 0;
}

TEST(PacketMean, TakesPointsWhereTheyVaryLessAndManyDrawsAreNeeded) {
  const auto points = [](float count, double many) { return points_mostly(1e-3, two, ramps(count), many); };
  EXPECT_GT(points(1, some), 1u);
  EXPECT_EQ(points(64, some), 1u) << "a ramp a point, which varies as it would alone";
  EXPECT_EQ(points(1, 1e7), 1u) << "few draws";
}

// Of one ramp replicates of 16 points vary so little that the range says how many there must be; of eight those of 64 vary less.
TEST(PacketMean, TakesTheNumberOfPointsThatTakesTheLeastTime) {
  EXPECT_EQ(points_mostly(1e-3, two, ramps(1), some), 16u);
  EXPECT_EQ(points_mostly(1e-4, two, ramps(8), some), 64u);
}

// Packets of ramps, of which the one drawn at the turn `bad` has NaNs. The first 1024 draws are a pilot.
Draws ramps_and_nans(std::uint64_t bad) {
  const auto drawn = std::make_shared<std::uint64_t>(0);
  return packet_draws([=](auto& source) {
    const Packet ramp = Packet(2) * source.next() + Packet(1);
    return (*drawn)++ == bad ? Packet(std::numeric_limits<float>::quiet_NaN()) : ramp;
  });
}

TEST(CheckMeanInPackets, FindsWhatItsPilotMeets) {
  const Finding nan = check_mean_in_packets(at_margin(1e-3), two, ramps_and_nans(100), some);
  EXPECT_EQ(nan.verdict, Verdict::biased);
  EXPECT_NE(nan.note.find("nan"), std::string::npos) << nan.note;
  EXPECT_NE(nan.note.find("in the pilot"), std::string::npos) << nan.note;
  const Finding above = check_mean_in_packets(at_margin(1e-3), {{2, 0, 2.9}}, ramps(1), some);
  EXPECT_EQ(above.verdict, Verdict::biased);
  EXPECT_NE(above.note.find("above"), std::string::npos) << above.note;
}

TEST(CheckMeanInPackets, HasOneVerdictWhateverTheNumbers) {
  for (const float count : {1.0f, 64.0f}) {
    const Trial trial = at_margin(1e-3);
    const Finding right = check_mean_in_packets(trial, two, ramps(count), some),
                  wrong = check_mean_in_packets(trial, two, ramps(count, 3e-3), some);
    EXPECT_EQ(right.verdict, Verdict::certified) << right.note;
    EXPECT_LT(right.interval.hi, 1e-3);
    EXPECT_EQ(wrong.verdict, Verdict::biased) << count;
    if (count == 1) {
      EXPECT_NE(wrong.note, "") << "points, which vary far less";
    }
  }
}

TEST(PacketMean, CountsDrawsOneByOne) {
  const Draws steady = packet_draws([](auto& source) { return Packet(2) + Packet(0) * source.next(); });
  const PacketMean mean(at_margin(1e-3), two, steady);
  const auto by_one = mean.test_each(at_margin(1e-3), {})[0].draws,
             by_set = mean.test_each(at_margin(1e-3), {16})[0].draws;
  EXPECT_EQ(by_set, 16 * by_one);
}

// One number in 1000 brings 5, which is out of the range; the mean of its replicate is not. A verdict on the mean takes
// more than a thousand replicates of 64, of which one in 16 has such a number.
TEST(PacketMean, FindsOnePointThatIsOutOfItsRange) {
  const Draws rare = packet_draws([](auto& source) {
    const Packet u = source.next();
    return Packet(select(u < Packet(1e-3f), Packet(5), Packet(2) * u + Packet(1)));
  });
  const PacketMean mean(at_margin(1e-3), two, rare);
  const Finding finding = worst_of(mean.test_each(at_margin(1e-3), {64}));
  EXPECT_EQ(finding.verdict, Verdict::biased);
  EXPECT_NE(finding.note.find("is 5 (one of those that it is the mean of"), std::string::npos) << finding.note;
}

TEST(CheckMeanInPackets, TakesIndependentNumbersAtTheMarginOfARun) {
  EXPECT_EQ(check_mean_in_packets(at_margin(1e-3), two, ramps(1, 3e-3)).note, "");
}

// Who is to hear the draws themselves.
TEST(CheckMeanInPackets, TakesIndependentNumbersWhereSomebodyListens) {
  Evidence evidence;
  std::uint64_t heard = 0;
  evidence.listener = [&](const auto&, const DrawBlock&, std::uint64_t draws) { heard = draws; };
  Trial watched = at_margin(1e-3);
  watched.evidence = &evidence;
  EXPECT_EQ(check_mean_in_packets(watched, two, ramps(1), some).draws, heard);
}

}  // namespace
}  // namespace fairlight

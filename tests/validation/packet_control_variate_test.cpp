#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <support/run_seed.h>

#include <fairlight/validation/checks/means.h>

namespace fairlight {
namespace {

const Trial trial{"packet_control_variate_test", testing::run_seed(), 1e-6, 0.01, 0.01};

// 2u + 1, whose mean is 2 and whose range is [1, 3], off by so much in each arithmetic.
auto ramp(double packets_bias, double double_bias) {
  return [=]<class Real>(std::type_identity<Real>, auto& source) {
    return Real((Real(2) * source.next() + Real(1)) *
                rounded<Real>(1 + (lanes<Real> > 1 ? packets_bias : double_bias)));
  };
}
const std::vector<Reference> two{{2, 0, 4}};

// `draw(type_identity<Real>, source)` in both arithmetics.
template <class Draw>
PairedDraws paired(const Draw& draw, std::size_t channels = 1) {
  return paired_draws<Packet>(body_of<double>(draw), body_of<Packet>(draw), channels);
}

constexpr std::array<SamplingScheme, 3> all_schemes{SamplingScheme{}, SamplingScheme{16}, SamplingScheme{64}};

// 2, off by so much in each arithmetic, without chance.
Finding found_steady(double packets_bias, double double_bias, const SamplingScheme& scheme) {
  const auto draw = [=]<class Real>(std::type_identity<Real>, auto& source) {
    return Real(rounded<Real>(2 * (1 + (lanes<Real> > 1 ? packets_bias : double_bias))) + Real(0) * source.next());
  };
  return PacketControlVariate(trial, two, paired(draw)).finding({scheme});
}

template <class Draw>
Finding found_independently(const Trial& t, const std::vector<Reference>& references, const Draw& draw) {
  return PacketControlVariate(t, references, paired(draw, references.size())).finding({});
}

TEST(PacketControlVariate, CertifiesTheMeanInDouble) {
  for (const SamplingScheme& scheme : all_schemes) {
    const Finding finding = PacketControlVariate(trial, two, paired(ramp(0, 0))).finding({scheme});
    EXPECT_EQ(finding.verdict, Verdict::certified) << finding.note;
    EXPECT_EQ(finding.guarantee, Guarantee::exact);
    EXPECT_EQ(finding.margin, trial.margin);
    EXPECT_LE(finding.interval.lo, finding.bias);
    EXPECT_GE(finding.interval.hi, finding.bias);
    EXPECT_LT(finding.interval.hi, trial.margin);
    EXPECT_DOUBLE_EQ(finding.rounding, 1e-5);
  }
}

TEST(PacketControlVariate, FindsABiasOfEitherArithmeticAndSaysWhich) {
  for (const SamplingScheme& scheme : all_schemes) {
    for (const double bias : {-0.02, 0.02}) {
      const Finding both = found_steady(bias, bias, scheme), packets = found_steady(bias, 0, scheme),
                    doubles = found_steady(0, bias, scheme);
      for (const Finding& finding : {both, packets, doubles}) {
        EXPECT_EQ(finding.verdict, Verdict::biased);
        EXPECT_EQ(finding.margin, trial.margin);
        EXPECT_NEAR(finding.bias, bias, finding.rounding);
      }
      EXPECT_TRUE(both.note.starts_with("tested in packets")) << both.note;
      EXPECT_TRUE(packets.note.starts_with("tested in packets")) << packets.note;
      EXPECT_EQ(packets.note.find("Sobol") != std::string::npos, !scheme.is_independent()) << packets.note;
      EXPECT_TRUE(doubles.note.starts_with("the difference between double and packets")) << doubles.note;
    }
  }
}

// One channel is off in packets by half of the margin, and another is as much in what double has more.
TEST(PacketControlVariate, AddsUpThePartsOfAChannel) {
  const auto draw = []<class Real>(std::type_identity<Real>, auto& source) {
    const Real x = Real(2) * source.next() + Real(1);
    return Rgb<Real>(x * rounded<Real>(1.005), x * rounded<Real>(lanes<Real> > 1 ? 1 : 1.001), x);
  };
  const Trial wide{"packet_control_variate_test", testing::run_seed(), 1e-6, 0.01, 0.1};
  const Finding finding = found_independently(wide, {{2, 0, 4}, {2, 0, 4}, {2, 0, 4}}, draw);
  EXPECT_EQ(finding.verdict, Verdict::certified) << finding.note;
  EXPECT_LE(finding.interval.lo, 0.005);
  EXPECT_GE(finding.interval.hi, 0.005);
}

// Of the difference nothing was drawn, so nothing is known of the mean in double, which is off.
TEST(PacketControlVariate, KnowsNothingOfTheMeanInDoubleBeforeTheDifferenceIsDrawn) {
  Trial stopped = trial;
  int looks = 0;
  stopped.watch = [&looks](double) { return ++looks < 3; };
  const Finding finding = PacketControlVariate(stopped, two, paired(ramp(0, 0.5))).finding({});
  ASSERT_EQ(finding.verdict, Verdict::undecided);
  EXPECT_EQ(finding.interval.lo, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(finding.interval.hi, std::numeric_limits<double>::infinity());
  EXPECT_EQ(finding.note, std::string("tested in packets: ") + told_to_end);
}

// Where the difference fails, the figures are its own, and exclude 0.
TEST(PacketControlVariate, ShowsTheFiguresOfTheDifferenceThatFails) {
  const Finding finding = PacketControlVariate(trial, two, paired(ramp(0, 0.006))).finding({});
  ASSERT_EQ(finding.verdict, Verdict::biased) << finding.note;
  EXPECT_GT(finding.interval.lo, 0);
  EXPECT_LT(finding.interval.hi, 0.01);
}

// Neither twice its range is out of the question for a difference, nor a number that is not finite.
TEST(PacketControlVariate, NamesADrawInDoubleThatIsOutOfItsRange) {
  for (const double value : {-0.1, 4.1, std::numeric_limits<double>::infinity(), std::nan("")}) {
    for (const double slack : {0.0, 1e-8}) {
      const auto draw = [=]<class Real>(std::type_identity<Real>, auto& source) {
        return Real(lanes<Real> > 1 ? rounded<Real>(2) : rounded<Real>(value)) + Real(0) * source.next();
      };
      const Finding finding = found_independently(trial, {{2, 0, 4, slack}}, draw);
      EXPECT_EQ(finding.verdict, Verdict::biased) << value;
      if (value == 4.1 && slack > 0) continue;
      EXPECT_NE(finding.note.find("draw 0 is "), std::string::npos) << finding.note;
      EXPECT_NE(finding.note.find("in double"), std::string::npos) << finding.note;
    }
  }
}

TEST(PacketControlVariate, PaysWhereTheVarianceSaysHowManyDrawsThereMustBe) {
  const auto draw = ramp(0, 0);
  const auto pays = [&](const Reference& reference, double margin) {
    const Trial one{"packet_control_variate_test", testing::run_seed(), 1e-6, 0.01, margin};
    return PacketControlVariate(one, {reference}, paired(draw)).pays().has_value();
  };
  EXPECT_TRUE(pays({2, 0, 4}, 1e-3));
  EXPECT_FALSE(pays({2, 0, 4000}, 1e-3));
  EXPECT_FALSE(pays({2, 0, 4}, 1e-5)) << "finer than floats round";
  EXPECT_TRUE(pays({2, 0, 4, 1e-8}, 1e-3));
  EXPECT_FALSE(pays({2, 0, 4, 1e-7}, 1e-3)) << "a tail that may hide too much";
  EXPECT_FALSE(pays({.mean = 2, .lower = 0, .upper = 4, .rounding = 2e-4}, 1e-3)) << "which 79 % does not take";
  EXPECT_THROW(pays({2, 0, 2.9}, 1e-3), BadDraw);
  EXPECT_FALSE(pays({2, 0, 4}, 1e-2)) << "so few draws";
  EXPECT_FALSE(pays({.mean = 2, .lower = 0, .upper = 4, .sides = Sides::not_above}, 1e-3));
}

TEST(CheckMeanInDouble, FindsWhatItsPilotMeets) {
  const Finding finding = check_mean_in_double({"check_mean_in_double_test", testing::run_seed(), 1e-6, 0.01, 1e-3},
                                               {{2, 0, 2.9}}, paired(ramp(0, 0)));
  EXPECT_EQ(finding.verdict, Verdict::biased);
  EXPECT_NE(finding.note.find("in the pilot"), std::string::npos) << finding.note;
}

// As where a packet goes on until the last of its lanes has ended.
TEST(PacketControlVariate, DoesNotPayWherePacketsDrawManyMoreNumbers) {
  const auto pays = [](int more) {
    const auto draw = [more]<class Real>(std::type_identity<Real> real, auto& source) {
      const Real ramp_of_the_first = ramp(0, 0)(real, source);
      for (int i = 0; i < (lanes < Real >> 1 ? more : 0); ++i) source.next();
      return ramp_of_the_first;
    };
    return PacketControlVariate({"packet_control_variate_test", testing::run_seed(), 1e-6, 0.01, 1e-3}, two,
                                paired(draw))
        .pays()
        .has_value();
  };
  EXPECT_TRUE(pays(0));
  EXPECT_FALSE(pays(40));
}

TEST(PacketControlVariate, TakesPointsWhereTheyVaryLess) {
  const Trial fine{"packet_control_variate_test", testing::run_seed(), 1e-6, 0.01, 1e-3};
  EXPECT_GT(PacketControlVariate(fine, two, paired(ramp(0, 0))).pays()->scheme.points, 1u);
}

// One path in so many parts from the double's, by half of the mean, either way. The ramp is one of 64 in a row, so that points vary no less.
TEST(PacketControlVariate, LeavesMoreToDifferencesWhereTheyAreDear) {
  const auto share = [](double parted) {
    const auto draw = [=]<class Real>(std::type_identity<Real>, auto& source) {
      const Real u = source.next();
      const Real way = select(u < rounded<Real>(parted / 2), Real(1), Real(-1));
      const Real apart = select(u < rounded<Real>(parted), way, Real(0));
      const Real ramps = Real(64) * source.next();
      using std::floor;
      return Real(Real(2) * (ramps - floor(ramps)) + Real(1) + (lanes<Real> > 1 ? Real(0) : apart));
    };
    const Trial fine{"packet_control_variate_test", testing::run_seed(), 1e-6, 0.01, 2.5e-4};
    return PacketControlVariate(fine, {{2, -4, 8}}, paired(draw)).pays()->share;
  };
  EXPECT_EQ(share(0), PacketControlVariate::Plan::shares.front());
  EXPECT_LT(share(0.05), PacketControlVariate::Plan::shares.front());
}

// Beyond its bound a draw is not the difference's matter, which else would have none.
TEST(PacketControlVariate, LeavesOutWhatIsInTheTail) {
  const auto draw = []<class Real>(std::type_identity<Real>, auto& source) {
    return Real(select(source.next() < Real(0.5), Real(1), rounded<Real>(lanes<Real> > 1 ? 11 : 21)));
  };
  const auto largest = [&](const Reference& reference) {
    std::vector channels(1, std::vector<double>(64));
    paired(draw).double_minus_packet(StreamKey(1, "tail"), {reference})(0, channels);
    return *std::ranges::max_element(channels[0]);
  };
  EXPECT_EQ(largest({10, 0, 30}), 10);
  EXPECT_EQ(largest({10, 0, 5, 1}), 0);
}

// The mean of e-values is one; of two parts the one that is off has the less wealth that speaks against it.
TEST(PacketControlVariate, LeavesTheWealthOfBothParts) {
  const Wealth joint = detail::joint(Wealth{std::log(3), 0, 5, 2}, Wealth{0, std::log(7), 1, 4});
  EXPECT_DOUBLE_EQ(joint.above_reference, std::log(2));
  EXPECT_DOUBLE_EQ(joint.below_reference, std::log(4));
  EXPECT_EQ(joint.below_upper_margin, 1);
  EXPECT_EQ(joint.above_lower_margin, 2);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(detail::joint(Wealth{infinite, 0, 0, 0}, Wealth{}).above_reference, infinite);
}

TEST(PacketControlVariate, LeavesOneLadderAChannelAndFewDrawsInDouble) {
  const Trial fine{"packet_control_variate_test", testing::run_seed(), 1e-6, 0.01, 2e-3};
  for (const double bias : {0.0, 2e-3}) {  // of double alone
    Evidence evidence;
    Trial watched = fine;
    watched.evidence = &evidence;
    const Finding finding = found_independently(watched, two, ramp(0, bias));
    ASSERT_EQ(evidence.margin_grid.channels.size(), 1u);
    ASSERT_EQ(evidence.means.size(), 2u);
    const auto in_packets = evidence.means[0].steps().back().draws,
               in_double = evidence.means[1].steps().back().draws;
    EXPECT_LT(4 * in_double, in_packets);
    const double margin = EvidenceSum(evidence.margin_grid).certified_margin(trial.beta);
    if (bias == 0) {
      EXPECT_EQ(finding.verdict, Verdict::certified);
      EXPECT_LE(margin, margin_of_level(first_level(fine.margin)));
    } else {
      EXPECT_EQ(finding.verdict, Verdict::biased);
      EXPECT_GT(margin, fine.margin);
    }
  }
}

// They hear draws in double, as many as the test took.
TEST(CheckMeanInDouble, IsAloneWhereSomebodyListens) {
  Evidence evidence;
  std::uint64_t heard = 0;
  evidence.listener = [&](const std::vector<Reference>& references, const DrawBlock& draw_block,
                          std::uint64_t draws) {
    std::vector channels(1, std::vector<double>(1));
    draw_block(0, channels);
    EXPECT_EQ(channels[0][0], 1.5);
    EXPECT_EQ(references[0].scale, 2);
    heard = draws;
  };
  Trial watched = trial;
  watched.evidence = &evidence;
  const auto draw = []<class Real>(std::type_identity<Real>, auto&) {
    return rounded<Real>(lanes<Real> > 1 ? 2 : 1.5);
  };
  EXPECT_EQ(check_mean_in_double(watched, {{2, 0, 4}}, paired(draw)).draws, heard);
}

TEST(CheckMeanInDouble, HasOneVerdictEitherWay) {
  for (const double upper : {4.0, 400.0}) {
    const std::vector<Reference> references{{2, 0, upper}};
    EXPECT_EQ(check_mean_in_double(trial, references, paired(ramp(0, 0))).verdict, Verdict::certified) << upper;
    EXPECT_EQ(check_mean_in_double(trial, references, paired(ramp(0.1, 0.1))).verdict, Verdict::biased) << upper;
  }
}

}  // namespace
}  // namespace fairlight

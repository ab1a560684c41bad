#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <support/run_seed.h>

#include <fairlight/validation/along_packets.h>

namespace fairlight {
namespace {

const Trial trial{"along_packets_test", testing::run_seed(), 1e-6, 0.01, 0.01};

// 2u + 1, whose mean is 2 and whose range is [1, 3], off by so much in each arithmetic.
auto ramp(double packets_bias, double double_bias) {
  return [=]<class Real>(std::type_identity<Real>, auto& source) {
    return Real((Real(2) * source.next() + Real(1)) *
                rounded<Real>(1 + (lanes<Real> > 1 ? packets_bias : double_bias)));
  };
}
const std::vector<Reference> two{{2, 0, 4}};

constexpr std::array<Spread, 3> all_spreads{Spread{}, Spread{16, true}, Spread{64, true}};

// 2, off by so much in each arithmetic, without chance.
Finding found_steady(double packets_bias, double double_bias, const Spread& spread) {
  const auto draw = [=]<class Real>(std::type_identity<Real>, auto& source) {
    return Real(rounded<Real>(2 * (1 + (lanes<Real> > 1 ? packets_bias : double_bias))) + Real(0) * source.next());
  };
  return AlongPackets(trial, two, draw).finding({spread});
}

template <class Draw>
Finding found_independently(const Trial& t, const std::vector<Reference>& references, const Draw& draw) {
  return AlongPackets(t, references, draw).finding({});
}

TEST(AlongPackets, CertifiesTheMeanInDouble) {
  for (const Spread& spread : all_spreads) {
    const Finding finding = AlongPackets(trial, two, ramp(0, 0)).finding({spread});
    EXPECT_EQ(finding.verdict, Verdict::certified) << finding.note;
    EXPECT_EQ(finding.guarantee, Guarantee::exact);
    EXPECT_EQ(finding.margin, trial.margin);
    EXPECT_LE(finding.interval.lo, finding.bias);
    EXPECT_GE(finding.interval.hi, finding.bias);
    EXPECT_LT(finding.interval.hi, trial.margin);
    EXPECT_DOUBLE_EQ(finding.rounding, 1e-5);
  }
}

TEST(AlongPackets, FindsABiasOfEitherArithmeticAndSaysWhich) {
  for (const Spread& spread : all_spreads) {
    for (const double bias : {-0.02, 0.02}) {
      const Finding both = found_steady(bias, bias, spread), packets = found_steady(bias, 0, spread),
                    doubles = found_steady(0, bias, spread);
      for (const Finding& finding : {both, packets, doubles}) {
        EXPECT_EQ(finding.verdict, Verdict::biased);
        EXPECT_EQ(finding.margin, trial.margin);
        EXPECT_NEAR(finding.bias, bias, finding.rounding);
      }
      EXPECT_TRUE(both.note.starts_with("seen in packets of floats")) << both.note;
      EXPECT_TRUE(packets.note.starts_with("seen in packets of floats")) << packets.note;
      EXPECT_EQ(packets.note.find("Sobol") != std::string::npos, spread.over_points) << packets.note;
      EXPECT_TRUE(doubles.note.starts_with("less its draws in packets")) << doubles.note;
    }
  }
}

// One channel is off in packets by half of the margin, and another is as much in what double has more.
TEST(AlongPackets, AddsUpThePartsOfAChannel) {
  const auto draw = []<class Real>(std::type_identity<Real>, auto& source) {
    const Real x = Real(2) * source.next() + Real(1);
    return Rgb<Real>(x * rounded<Real>(1.005), x * rounded<Real>(lanes<Real> > 1 ? 1 : 1.001), x);
  };
  const Trial wide{"along_packets_test", testing::run_seed(), 1e-6, 0.01, 0.1};
  const Finding finding = found_independently(wide, {{2, 0, 4}, {2, 0, 4}, {2, 0, 4}}, draw);
  EXPECT_EQ(finding.verdict, Verdict::certified) << finding.note;
  EXPECT_LE(finding.interval.lo, 0.005);
  EXPECT_GE(finding.interval.hi, 0.005);
}

// Neither twice its range is out of the question for a difference, nor a number that is not finite.
TEST(AlongPackets, NamesADrawInDoubleThatIsOutOfItsRange) {
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

TEST(AlongPackets, PaysWhereTheVarianceSaysHowManyDrawsThereMustBe) {
  const auto draw = ramp(0, 0);
  const auto pays = [&](const Reference& reference, double margin) {
    const Trial one{"along_packets_test", testing::run_seed(), 1e-6, 0.01, margin};
    return AlongPackets(one, {reference}, draw).pays().has_value();
  };
  EXPECT_TRUE(pays({2, 0, 4}, 1e-3));
  EXPECT_FALSE(pays({2, 0, 4000}, 1e-3));
  EXPECT_FALSE(pays({2, 0, 4}, 1e-5)) << "finer than floats round";
  EXPECT_TRUE(pays({2, 0, 4, 1e-8}, 1e-3));
  EXPECT_FALSE(pays({2, 0, 4, 1e-7}, 1e-3)) << "a tail that may hide too much";
  EXPECT_FALSE(pays({.mean = 2, .lower = 0, .upper = 4, .rounding = 2e-4}, 1e-3)) << "which 79 % does not take";
  EXPECT_FALSE(pays({2, 0, 2.9}, 1e-3)) << "out of the range";
  EXPECT_FALSE(pays({2, 0, 4}, 1e-2)) << "so few draws";
  EXPECT_FALSE(pays({.mean = 2, .lower = 0, .upper = 4, .sides = Sides::not_above}, 1e-3));
}

// As where a packet goes on until the last of its lanes has ended.
TEST(AlongPackets, DoesNotPayWherePacketsDrawManyMoreNumbers) {
  const auto pays = [](int more) {
    const auto draw = [more]<class Real>(std::type_identity<Real> real, auto& source) {
      const Real ramp_of_the_first = ramp(0, 0)(real, source);
      for (int i = 0; i < (lanes < Real >> 1 ? more : 0); ++i) source.next();
      return ramp_of_the_first;
    };
    return AlongPackets({"along_packets_test", testing::run_seed(), 1e-6, 0.01, 1e-3}, two, draw)
        .pays()
        .has_value();
  };
  EXPECT_TRUE(pays(0));
  EXPECT_FALSE(pays(40));
}

TEST(AlongPackets, TakesPointsWhereTheyVaryLess) {
  const Trial fine{"along_packets_test", testing::run_seed(), 1e-6, 0.01, 1e-3};
  EXPECT_GT(AlongPackets(fine, two, ramp(0, 0)).pays()->spread.count, 1u);
}

// One path in so many parts from the double's, by half of the mean, either way. The ramp is one of 64 in a row, so that points vary no less.
TEST(AlongPackets, LeavesMoreToDifferencesWhereTheyAreDear) {
  const auto share = [](double parted) {
    const auto draw = [=]<class Real>(std::type_identity<Real>, auto& source) {
      const Real u = source.next();
      const Real way = select(u < rounded<Real>(parted / 2), Real(1), Real(-1));
      const Real apart = select(u < rounded<Real>(parted), way, Real(0));
      const Real ramps = Real(64) * source.next();
      using std::floor;
      return Real(Real(2) * (ramps - floor(ramps)) + Real(1) + (lanes<Real> > 1 ? Real(0) : apart));
    };
    const Trial fine{"along_packets_test", testing::run_seed(), 1e-6, 0.01, 2.5e-4};
    return AlongPackets(fine, {{2, -4, 8}}, draw).pays()->share;
  };
  EXPECT_EQ(share(0), PacketPlan::shares.front());
  EXPECT_LT(share(0.05), PacketPlan::shares.front());
}

// Beyond its bound a draw is not the difference's matter, which else would have none.
TEST(AlongPackets, LeavesOutWhatIsInTheTail) {
  const auto draw = []<class Real>(std::type_identity<Real>, auto& source) {
    return Real(select(source.next() < Real(0.5), Real(1), rounded<Real>(lanes<Real> > 1 ? 11 : 21)));
  };
  const auto largest = [&](const Reference& reference) {
    std::vector channels(1, std::vector<double>(64));
    less_packets(StreamKey(1, "tail"), {reference}, draw)(0, channels);
    return *std::ranges::max_element(channels[0]);
  };
  EXPECT_EQ(largest({10, 0, 30}), 10);
  EXPECT_EQ(largest({10, 0, 5, 1}), 0);
}

// The mean of e-values is one; of two parts the one that is off has the less wealth that speaks against it.
TEST(AlongPackets, LeavesTheWealthOfBothParts) {
  const Wealth joint = detail::joint(Wealth{std::log(3), 0, 5, 2}, Wealth{0, std::log(7), 1, 4});
  EXPECT_DOUBLE_EQ(joint.too_bright, std::log(2));
  EXPECT_DOUBLE_EQ(joint.too_dark, std::log(4));
  EXPECT_EQ(joint.not_brighter, 1);
  EXPECT_EQ(joint.not_darker, 2);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(detail::joint(Wealth{infinite, 0, 0, 0}, Wealth{}).too_bright, infinite);
}

TEST(AlongPackets, LeavesOneLadderAChannelAndFewDrawsInDouble) {
  const Trial fine{"along_packets_test", testing::run_seed(), 1e-6, 0.01, 2e-3};
  for (const double bias : {0.0, 2e-3}) {  // of double alone
    Evidence evidence;
    Trial watched = fine;
    watched.evidence = &evidence;
    const Finding finding = found_independently(watched, two, ramp(0, bias));
    ASSERT_EQ(evidence.ladder.channels.size(), 1u);
    ASSERT_EQ(evidence.means.size(), 2u);
    const auto in_packets = evidence.means[0].steps().back().draws,
               in_double = evidence.means[1].steps().back().draws;
    EXPECT_LT(4 * in_double, in_packets);
    const double margin = Account(evidence.ladder).certified_margin(trial.beta);
    if (bias == 0) {
      EXPECT_EQ(finding.verdict, Verdict::certified);
      EXPECT_LE(margin, margin_of_rung(first_rung(fine.margin)));
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
  EXPECT_EQ(check_mean_in_double(watched, {{2, 0, 4}}, draw).draws, heard);
}

TEST(CheckMeanInDouble, HasOneVerdictEitherWay) {
  for (const double upper : {4.0, 400.0}) {
    const std::vector<Reference> references{{2, 0, upper}};
    EXPECT_EQ(check_mean_in_double(trial, references, ramp(0, 0)).verdict, Verdict::certified) << upper;
    EXPECT_EQ(check_mean_in_double(trial, references, ramp(0.1, 0.1)).verdict, Verdict::biased) << upper;
  }
}

}  // namespace
}  // namespace fairlight

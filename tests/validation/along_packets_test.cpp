#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <fairlight/validation/along_packets.h>

namespace fairlight {
namespace {

const Trial trial{"along_packets_test", 1, 1e-6, 0.01, 0.01};

// 2u + 1, whose mean is 2 and whose range is [1, 3], off by so much in each arithmetic.
auto ramp(double packets_bias, double double_bias) {
  return [=]<class Real>(std::type_identity<Real>, auto& source) {
    return Real((Real(2) * source.next() + Real(1)) *
                rounded<Real>(1 + (lanes<Real> > 1 ? packets_bias : double_bias)));
  };
}
const std::vector<Reference> two{{2, 0, 4}};

Finding found(double packets_bias, double double_bias) {
  const auto draw = ramp(packets_bias, double_bias);
  return AlongPackets(trial, two, draw).finding();
}

TEST(AlongPackets, CertifiesTheMeanInDoubleWithFewDrawsOfIt) {
  const Finding finding = found(0, 0);
  EXPECT_EQ(finding.verdict, Verdict::certified) << finding.note;
  EXPECT_EQ(finding.guarantee, Guarantee::exact);
  EXPECT_EQ(finding.margin, trial.margin);
  EXPECT_LE(finding.interval.lo, finding.bias);
  EXPECT_GE(finding.interval.hi, finding.bias);
  EXPECT_LT(finding.interval.hi, trial.margin);
  EXPECT_EQ(finding.rounding, 1e-5);
}

TEST(AlongPackets, FindsABiasOfEitherArithmeticAndSaysWhich) {
  for (const double bias : {-0.02, 0.02}) {
    const Finding both = found(bias, bias), packets = found(bias, 0), doubles = found(0, bias);
    for (const Finding& finding : {both, packets, doubles}) EXPECT_EQ(finding.verdict, Verdict::biased);
    EXPECT_TRUE(both.note.starts_with("in packets of floats")) << both.note;
    EXPECT_TRUE(packets.note.starts_with("in packets of floats")) << packets.note;
    EXPECT_TRUE(doubles.note.starts_with("less its draws in packets")) << doubles.note;
    EXPECT_NEAR(doubles.bias / bias, 1, 0.5);
  }
}

TEST(AlongPackets, NamesADrawInDoubleThatIsOutOfItsRange) {
  const Finding finding = found(0, 10);
  EXPECT_EQ(finding.verdict, Verdict::biased);
  EXPECT_NE(finding.note.find("draw 0 is "), std::string::npos) << finding.note;
}

TEST(AlongPackets, PaysWhereTheVarianceSaysHowManyDrawsThereMustBe) {
  const auto draw = ramp(0, 0);
  const auto pays = [&](const Reference& reference, double margin) {
    const Trial one{"along_packets_test", 1, 1e-6, 0.01, margin};
    return AlongPackets(one, {reference}, draw).pays();
  };
  EXPECT_TRUE(pays({2, 0, 4}, 1e-3));
  EXPECT_FALSE(pays({2, 0, 4000}, 1e-3));
  EXPECT_FALSE(pays({2, 0, 4}, 1e-5)) << "finer than floats round";
  EXPECT_TRUE(pays({2, 0, 4, 1e-8}, 1e-3));
  EXPECT_FALSE(pays({2, 0, 4, 1e-6}, 1e-3)) << "a tail that may hide the margin's thousandth";
  EXPECT_FALSE(pays({2, 0, 2.9}, 1e-3)) << "out of the range";
  EXPECT_FALSE(pays({.mean = 2, .lower = 0, .upper = 4, .sides = Sides::not_above}, 1e-3));
}

// Beyond its bound a draw is not the difference's matter, which else would have none.
TEST(AlongPackets, LeavesOutWhatIsInTheTail) {
  const auto draw = []<class Real>(std::type_identity<Real>, auto& source) {
    const Real u = source.next();
    return Real(Real(1) + select(u < Real(0.5), Real(0), rounded<Real>(lanes<Real> > 1 ? 10 : 20)));
  };
  std::vector channels(1, std::vector<double>(64));
  less_packets(StreamKey(1, "tail"), {infinity<double>}, draw)(0, channels);
  EXPECT_EQ(*std::ranges::max_element(channels[0]), 10);
  less_packets(StreamKey(1, "tail"), {5}, draw)(0, channels);
  EXPECT_EQ(*std::ranges::max_element(channels[0]), 0);
  const auto nothing = []<class Real>(std::type_identity<Real>, auto&) { return Real(std::nanf("")); };
  less_packets(StreamKey(1, "tail"), {5}, nothing)(0, channels);
  EXPECT_TRUE(std::isnan(channels[0][0]));
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

TEST(AlongPackets, LeavesOneLadderAChannelAndTheDrawsToListeners) {
  const auto draw = ramp(0, 0);
  Evidence evidence;
  std::uint64_t heard = 0;
  evidence.listener = [&](const std::vector<Reference>& references, const DrawBlock&, std::uint64_t draws) {
    EXPECT_EQ(references[0].scale, 2);
    heard += draws;
  };
  Trial watched = trial;
  watched.evidence = &evidence;
  const Finding finding = AlongPackets(watched, two, draw).finding();
  EXPECT_EQ(finding.verdict, Verdict::certified);
  EXPECT_EQ(evidence.ladder.channels.size(), 1u);
  EXPECT_EQ(evidence.means.size(), 2u);
  EXPECT_GT(heard, 0u);
  EXPECT_LT(heard, finding.draws);
  EXPECT_LE(Account(evidence.ladder).certified_margin(trial.beta), trial.margin);
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

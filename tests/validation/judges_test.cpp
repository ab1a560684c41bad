#include <cmath>
#include <limits>

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <gtest/gtest.h>

#include <fairlight/estimators/stream.h>
#include <fairlight/stats/seed.h>
#include <fairlight/validation/audit/judges.h>
#include <fairlight/validation/audit/judges_audit.h>

namespace fairlight {
namespace {

using Channel = std::vector<double>;

JudgedDraws drawn(const std::vector<Channel>& channels, double variance = 1) {
  JudgedDraws draws{{}, std::vector<double>(channels.size(), variance)};
  for (const Channel& channel : channels) draws.channels.emplace_back(channel);
  return draws;
}

// Four draws of variance 1 and mean 1 + off: with the standard error 1/2, the mean is 2 off standard errors from 1.
Channel four(double off) { return {off - 0.5, off + 1.5, off + 1.5, off + 1.5}; }

Channel joined(std::initializer_list<Channel> parts) {
  Channel all;
  for (const Channel& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

const double not_a_number = std::numeric_limits<double>::quiet_NaN();

TEST(Pbrt, FailsAnAverageOverAllChannelsThatIsOffByMoreThanTwoAndAHalfPercent) {
  EXPECT_FALSE(fails_by_pbrt(drawn({{1.01, 1.03}})));
  EXPECT_TRUE(fails_by_pbrt(drawn({{1.02, 1.04}})));
  EXPECT_TRUE(fails_by_pbrt(drawn({{0.96, 0.98}})));
  EXPECT_FALSE(fails_by_pbrt(drawn({{1.1, 1.1}, {0.9, 0.9}}))) << "channels make up for each other";
  EXPECT_TRUE(fails_by_pbrt(drawn({{1, not_a_number}})));
}

// Of four pixels each is tested at 1 - 0.99^(1/4) = 0.25 %, which is 3.02 standard errors; 0.9975 * 4 = 3.99 must pass.
TEST(Mitsuba, FailsAPictureOfFourPixelsIfOneIsThreeStandardErrorsOff) {
  const Channel right(6, 1.0);
  EXPECT_FALSE(fails_by_mitsuba(drawn({joined({right, {3.1, 3.1}})}), 4)) << "2.1 sqrt(2) = 2.97";
  EXPECT_TRUE(fails_by_mitsuba(drawn({joined({right, {3.2, 3.2}})}), 4)) << "2.2 sqrt(2) = 3.11";
  EXPECT_FALSE(fails_by_mitsuba(drawn({joined({right, {3.2, 3.2}})}, 1.2), 4)) << "2.2 sqrt(2 / 1.2) = 2.84";
  EXPECT_FALSE(fails_by_mitsuba(drawn({joined({right, {1.02, 1.02}})}, 0), 4)) << "0.02 sqrt(2 / 1e-4) = 2.83";
  EXPECT_TRUE(fails_by_mitsuba(drawn({joined({right, {1, not_a_number}})}), 4));
}

TEST(Mitsuba, AllowsOnePixelOfFourHundred) {
  Channel draws(800, 1.0);
  draws[0] = draws[17] = 7;
  EXPECT_FALSE(fails_by_mitsuba(drawn({draws}), 800)) << "0.9975 * 800 = 798 pass";
  draws[42] = 7;
  EXPECT_TRUE(fails_by_mitsuba(drawn({draws}), 800));
  EXPECT_FALSE(fails_by_mitsuba(drawn({draws, Channel(800, 1.0)}), 800)) << "three of two channels' 1600";
}

TEST(Mitsuba, MakesASmallerPictureOfFewDraws) { EXPECT_TRUE(fails_by_mitsuba(drawn({{1, 5}}))); }

// Three degrees of freedom at 1 %: 5.84; at 1 - 0.99^(1/2) = 0.5 %: 7.45.
TEST(Nori, FailsByStudentsLaw) {
  EXPECT_FALSE(fails_by_nori(drawn({four(2.9)}))) << "t = 5.8";
  EXPECT_TRUE(fails_by_nori(drawn({four(3.0)}))) << "t = 6";
  EXPECT_TRUE(fails_by_nori(drawn({four(-3.0)})));
  EXPECT_FALSE(fails_by_nori(drawn({four(3.0), four(0)}))) << "one test of two";
  EXPECT_TRUE(fails_by_nori(drawn({four(3.8), four(0)}))) << "t = 7.6";
  EXPECT_FALSE(fails_by_nori(drawn({{1.002, 1.002}}))) << "0.002 sqrt(2 / 1e-5) = 0.9";
  EXPECT_FALSE(fails_by_nori(drawn({{5}}))) << "one draw has no spread";
}

TEST(OpenMC, FailsAtFourStandardErrorsTwice) {
  EXPECT_FALSE(fails_by_openmc(drawn({joined({four(1.9), four(1.9)})})));
  EXPECT_FALSE(fails_by_openmc(drawn({joined({four(2.1), four(1.9)})}))) << "the rerun passes";
  EXPECT_FALSE(fails_by_openmc(drawn({joined({four(1.9), four(2.1)})}))) << "there is none";
  EXPECT_TRUE(fails_by_openmc(drawn({joined({four(2.1), four(-2.1)})})));
  EXPECT_TRUE(fails_by_openmc(drawn({joined({four(2.1), four(0)}), joined({four(0), four(2.1)})})))
      << "whole runs, of all channels";
  EXPECT_FALSE(fails_by_openmc(drawn({Channel(8, 1.0)}))) << "a constant that is right";
}

// Each of 100 trials is passed with probability 0.9999: 3.89 standard errors. Two draws 1 + off -+ 1 have the standard error 1.
TEST(Abseil, AllowsOneTrialOfAHundredToFail) {
  const auto pair = [](double off) { return Channel{off, off + 2}; };
  Channel draws;
  for (int trial = 0; trial < 98; ++trial) draws.insert(draws.end(), {0.0, 2.0});
  EXPECT_FALSE(fails_by_abseil(drawn({joined({draws, pair(0), pair(3.95)})})));
  EXPECT_FALSE(fails_by_abseil(drawn({joined({draws, pair(3.85), pair(3.95)})})));
  EXPECT_TRUE(fails_by_abseil(drawn({joined({draws, pair(-3.95), pair(3.95)})})));
  EXPECT_TRUE(fails_by_abseil(drawn({joined({draws, pair(0), pair(0)}), joined({draws, pair(4), pair(4)})})));
  EXPECT_FALSE(fails_by_abseil(drawn({{5}}))) << "no trial";
}

double normal_draw(double u) { return boost::math::quantile(boost::math::normal(), (u * 0x1p53 + 0.5) * 0x1p-53); }

// Right draws, exactly normal, on which Nori's test and Mitsuba's, of four pixels that must all pass, fail with probability 1 %.
TEST(Judges, FailNormalDrawsAsOftenAsTheirLevelSays) {
  const std::uint64_t seed = fresh_seed();
  const StreamKey key(seed, "judges_test");
  constexpr int runs = 5000;
  int nori = 0, mitsuba = 0;
  for (int run = 0; run < runs; ++run) {
    PhiloxStream<double> source(key, 0, static_cast<std::uint64_t>(run));
    Channel draws(8);
    for (double& x : draws) x = 1 + normal_draw(source.next());
    nori += fails_by_nori(drawn({draws})) ? 1 : 0;
    mitsuba += fails_by_mitsuba(drawn({draws}), 4) ? 1 : 0;
  }
  const boost::math::binomial law(runs, 0.01);
  for (int failed : {nori, mitsuba}) {
    EXPECT_GT(cdf(law, failed), 1e-9) << failed << ", seed " << seed_text(seed);
    EXPECT_GT(cdf(complement(law, failed - 1)), 1e-9) << failed << ", seed " << seed_text(seed);
  }
}

RunOptions coarse(std::uint64_t seed, int threads) {
  RunOptions run_options{{.seed = seed}, threads};
  run_options.terms.margin = 0.01;
  return run_options;
}

std::vector<int> counts(const JudgesOutcome& outcome) {
  std::vector<int> all;
  for (const JudgeOutcome& o : outcome.judges) {
    for (const Share& s : {o.alarms, o.alarms_planned, o.suites, o.kills, o.kills_planned, o.faults}) {
      all.insert(all.end(), {s.count, s.of});
    }
  }
  return all;
}

TEST(JudgesAudit, IsExactToTheSeedWhateverTheThreads) {
  const std::uint64_t seed = fresh_seed();
  const JudgesOutcome one = audit_judges(coarse(seed, 1), 1);
  const JudgesOutcome two = audit_judges(coarse(seed, 2), 1);
  EXPECT_EQ(counts(one), counts(two)) << seed_text(seed);
  EXPECT_EQ(one.planned_draws, two.planned_draws);
  ASSERT_EQ(one.judges.size(), 1 + judges().size());
  const JudgeOutcome& fairlight = one.judges.front();
  EXPECT_EQ(fairlight.alarms.count, 0) << seed_text(seed);
  EXPECT_EQ(fairlight.alarms.of, one.rows);
  EXPECT_EQ(fairlight.kills.of, one.cells);
  EXPECT_EQ(fairlight.missed.size(), static_cast<std::size_t>(fairlight.faults.of - fairlight.faults.count));
}

}  // namespace
}  // namespace fairlight

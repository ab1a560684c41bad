#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <support/run_seed.h>

#include <fairlight/estimators/hemisphere.h>
#include <fairlight/estimators/latin_hypercube.h>
#include <fairlight/stats/domains.h>
#include <fairlight/validation/checks/constants.h>
#include <fairlight/validation/checks/laws.h>
#include <fairlight/validation/checks/variances.h>

// Each check must be able to fail: it is shown estimators that are wrong without chance.
namespace fairlight {
namespace {

const Trial trial{"checks_test", testing::run_seed(), 1e-6, 0.01, 0.05};

TEST(CheckMean, CertifiesTheMeanAndOnlyTheMean) {
  const auto constant = [](auto&) { return 2.0; };
  EXPECT_EQ(check_mean(trial, {{2, 0, 4}}, constant).verdict, Verdict::certified);
  EXPECT_EQ(check_mean(trial, {{2.2, 0, 4}}, constant).verdict, Verdict::biased);
  EXPECT_EQ(check_mean(trial, {{1.8, 0, 4}}, constant).verdict, Verdict::biased);
}

// A weight that is hardly above its mean, by a margin of 5 %.
TEST(CheckMean, TakesAMarginThatLeadsOutOfTheRange) {
  const Reference nearly_all{.mean = 1, .lower = 0, .upper = 1.01};
  EXPECT_EQ(check_mean(trial, {nearly_all}, [](auto&) { return 1.0; }).verdict, Verdict::certified);
  EXPECT_EQ(check_mean(trial, {nearly_all}, [](auto&) { return 0.9; }).verdict, Verdict::biased);
}

TEST(CheckMean, IsBiasedWhenOneChannelIs) {
  const auto rgb = [](auto&) { return Rgb<double>(1, 2, 3); };
  EXPECT_EQ(check_mean(trial, {{1, 0, 5}, {2, 0, 5}, {3, 0, 5}}, rgb).verdict, Verdict::certified);
  EXPECT_EQ(check_mean(trial, {{1, 0, 5}, {2.4, 0, 5}, {3, 0, 5}}, rgb).verdict, Verdict::biased);
}

TEST(CheckMean, ReportsTheBiasRelativeToTheReference) {
  const Finding finding = check_mean(trial, {{1.6, 0, 4}}, [](auto&) { return 2.0; });
  EXPECT_DOUBLE_EQ(finding.bias, 0.25);
  EXPECT_GT(finding.interval.lo, 0);
  EXPECT_EQ(finding.guarantee, Guarantee::exact);
  EXPECT_EQ(finding.token, seed_text(trial.seed));
}

TEST(CheckMean, NamesADrawThatIsOutOfItsRange) {
  for (double wrong : {std::numeric_limits<double>::quiet_NaN(), -1.0, 100.0}) {
    const Finding finding = check_mean(trial, {{2, 0, 4}}, [wrong](auto&) { return wrong; });
    EXPECT_EQ(finding.verdict, Verdict::biased) << wrong;
    EXPECT_NE(finding.note.find("draw 0"), std::string::npos) << finding.note;
  }
}

// Draw i is i in one channel and -i in the other, whatever the blocks that it is asked for in: whole packets, parts of them, the rest
// of one that has been made.
template <class Real>
void expect_draws_in_their_places() {
  const auto draws = draws_at_once(lanes<Real>, 2, [](std::uint64_t first, std::span<double* const> places) {
    EXPECT_EQ(first % lanes<Real>, 0u);
    for (std::size_t i = 0; i < lanes<Real>; ++i) {
      places[0][i] = static_cast<double>(first + i);
      places[1][i] = -places[0][i];
    }
  });
  std::uint64_t first = 0;
  for (const std::size_t size : {1, 2, 64, 3, 1, 16, 61, 4, 16, 8, 5, 64, 33}) {
    std::vector channels(2, std::vector<double>(size));
    draws(first, channels);
    for (std::size_t i = 0; i < size; ++i) {
      EXPECT_EQ(channels[0][i], static_cast<double>(first + i));
      EXPECT_EQ(channels[1][i], -static_cast<double>(first + i));
    }
    first += size;
  }
}
TEST(DrawsAtOnce, AreInTheirPlacesWhateverTheBlocks) {
  expect_draws_in_their_places<double>();
  expect_draws_in_their_places<Packet>();
}

// In packets a bias of the arithmetic's rounding, 5e-6, is no bias; one of 1e-3 is.
TEST(CheckMean, AllowsPacketsTheirRounding) {
  const Trial fine{"checks_test", testing::run_seed(), 1e-6, 0.01, 1e-3};
  const auto off = [](float bias) { return [bias](auto&) { return Packet(2 * (1 + bias)); }; };
  EXPECT_EQ(check_mean<Packet>(fine, {{2, 0, 4}}, off(2e-6f)).verdict, Verdict::certified);
  EXPECT_EQ(check_mean<Packet>(fine, {{2, 0, 4}}, off(2e-3f)).verdict, Verdict::biased);
  EXPECT_EQ(check_mean<Packet>(fine, {{2, 0, 4}}, off(-2e-3f)).verdict, Verdict::biased);
  EXPECT_EQ(check_mean<Packet>(fine, {{2, 0, 4}}, off(0)).rounding, 5e-6);
}

TEST(CheckMean, DrawsEveryLane) {
  const Trial fine{"checks_test", testing::run_seed(), 1e-6, 0.01, 1e-4};  // so that blocks grow beyond one lane
  for (std::size_t lane = 0; lane < lanes<Packet>; ++lane) {
    std::array<float, lanes<Packet>> values{};
    values.fill(0.5f);
    values[lane] = 100;
    const auto draw = [&](auto&) { return Packet::load_unaligned(values.data()); };
    const Finding finding = check_mean<Packet>(fine, {{0.5, 0, 1}}, draw);
    EXPECT_NE(finding.note.find(" is 100 "), std::string::npos) << lane << ": " << finding.note;
  }
}

// A cosine hemisphere in packets whose density is `factor` times too large.
struct PacketHemisphere : CosineHemisphere<Packet> {
  float factor;
  explicit PacketHemisphere(float f) : factor(f) {}
  Density<SolidAngle, Packet> pdf(const Vec3<Packet>& w) const {
    return Density<SolidAngle, Packet>(factor * CosineHemisphere<Packet>::pdf(w).value());
  }
};

TEST(CheckDensity, HoldsPacketsToDouble) {
  const CosineHemisphere<double> law;
  EXPECT_EQ(check_density(trial, PacketHemisphere(1), law).verdict, Verdict::certified);
  EXPECT_EQ(check_density(trial, PacketHemisphere(1.1f), law).verdict, Verdict::biased);
  EXPECT_EQ(check_density(trial, PacketHemisphere(0.9f), law).verdict, Verdict::biased);
  EXPECT_EQ(check_density(trial, PacketHemisphere(3), law).verdict, Verdict::biased);
}

TEST(ReplicateMean, IsTheMeanOverThePointsOfOneReplicate) {
  using Set = LatinHypercube<double>;
  const StreamKey key(1, "test");
  const auto draw = [](auto& source) { return source.next(); };
  const Set set(key, 5, 2);
  EXPECT_EQ(replicate_mean<Set>(key, 5, 2, draw), (set.source(0).next() + set.source(1).next()) / 2);
  EXPECT_NE(replicate_mean<Set>(key, 5, 2, draw), replicate_mean<Set>(key, 6, 2, draw));
}

TEST(CheckReplicates, CertifiesTheMeanAndOnlyTheMean) {
  const auto check = [](double mean) {
    const auto body = body_of<double>([](auto, auto& source) {
      const double u = source.next();
      return Eigen::Array2d(u, 2 * u + 1);
    });
    return check_replicates<LatinHypercube<double>>(trial, {{0.5, 0, 1}, {mean, 1, 3}}, body, points_a_replicate)
        .verdict;
  };
  EXPECT_EQ(check(2), Verdict::certified);
  EXPECT_EQ(check(2.2), Verdict::biased);
  EXPECT_EQ(check(1.8), Verdict::biased);
}

TEST(PointsFor, AreFewerWhereTheRangeIsWide) {
  EXPECT_EQ(points_for({{1, 0, 8}}), 64u);
  EXPECT_EQ(points_for({{1, 0, 8}, {1, 0, 9}}), 16u);
  EXPECT_EQ(points_for({{.mean = 0, .lower = -1, .upper = 1, .scale = 1}}), 64u);
}

// (0.1 + 0.1 + 0.1) / 3 rounds to more than 0.1.
TEST(CheckReplicates, AllowsTheRoundingOfTheSumAndNoMore) {
  const auto note = [](double value) {
    const auto body = body_of_source<double>([value](auto&) { return value; });
    return check_replicates<LatinHypercube<double>>(trial, {{0.05, 0, 0.1}}, body, 3).note;
  };
  EXPECT_EQ(note(0.1).find("draw 0"), std::string::npos) << note(0.1);
  EXPECT_NE(note(0.1 * (1 + 1e-14)).find("draw 0"), std::string::npos);
}

TEST(CheckConstant, AllowsAFewUlpAndNoMore) {
  const auto next_to_one = [](auto&) { return 1 + 2 * std::numeric_limits<double>::epsilon(); };
  EXPECT_EQ(check_constant(trial, 1, 2, next_to_one).verdict, Verdict::certified);
  EXPECT_EQ(check_constant(trial, 1, 1, next_to_one).verdict, Verdict::biased);
  EXPECT_EQ(check_constant(trial, 1, 2, [](auto&) { return std::nan(""); }).verdict, Verdict::biased);
}

// A sample shows that few draws are off, not that none is.
TEST(CheckConstant, SaysWhatShareOfDrawsItShows) {
  const Finding right = check_constant(trial, 1, 1, [](auto&) { return 1.0; });
  EXPECT_EQ(right.guarantee, Guarantee::exact);
  EXPECT_EQ(right.note, "all draws but a share of 4.5e-05, at a miss rate of 1 %");
  const Finding wrong = check_constant(trial, 1, 1, [](auto&) { return 2.0; });
  EXPECT_EQ(wrong.guarantee, Guarantee::deterministic) << "one draw refutes it";
}

// A hemisphere whose density is wrong by a factor, or which strays below the horizon.
struct Doubled : CosineHemisphere<double> {
  Density<SolidAngle, double> pdf(const Vec3<double>& w) const {
    return Density<SolidAngle, double>(2 * CosineHemisphere<double>::pdf(w).value());
  }
};
struct Flipped : CosineHemisphere<double> {
  Vec3<double> sample(const Vec2<double>& u) const { return -CosineHemisphere<double>::sample(u); }
};
struct Swapped : UniformHemisphere<double> {
  Vec3<double> sample(const Vec2<double>& u) const { return CosineHemisphere<double>().sample(u); }
};

TEST(CheckLaw, CertifiesASamplerThatFollowsItsDensity) {
  EXPECT_EQ(check_law(trial, CosineHemisphere<double>{}, HemisphereDomain{}).verdict, Verdict::certified);
}

TEST(CheckLaw, FindsADensityThatIntegratesToTwo) {
  const Finding finding = check_law(trial, Doubled{}, HemisphereDomain{});
  EXPECT_EQ(finding.verdict, Verdict::biased);
  EXPECT_NE(finding.note.find("integrates to 2.0"), std::string::npos) << finding.note;
}

TEST(CheckLaw, FindsADrawWhereTheDensityIsZero) {
  const Finding finding = check_law(trial, Flipped{}, HemisphereDomain{});
  EXPECT_EQ(finding.verdict, Verdict::biased);
  EXPECT_NE(finding.note.find("draw 0"), std::string::npos) << finding.note;
}

TEST(CheckLaw, FindsDrawsOfAnotherLaw) {
  EXPECT_EQ(check_law(trial, Swapped{}, HemisphereDomain{}).verdict, Verdict::biased);
}

TEST(CheckLawMoments, SeeTheSameOverPointsInAFractionOfTheDraws) {
  Trial fine = trial;
  fine.margin = 0.005;
  const HemisphereDomain domain;
  const CosineHemisphere<double> cosine;
  const Finding packets = check_law_moments_over_points(fine, CosineHemisphere<Packet>{}, cosine, domain);
  const Finding points = check_law_moments_over_points(fine, cosine, cosine, domain);
  const Finding independent = check_law_moments(fine, cosine, cosine, domain);
  for (const Finding& each : {packets, points, independent}) EXPECT_EQ(each.verdict, Verdict::certified);
  EXPECT_LT(2 * points.draws, independent.draws);
  EXPECT_EQ(check_law_moments_over_points(fine, Swapped{}, Swapped{}, domain).verdict, Verdict::biased);
}

TEST(IndependentPairs, AreTheNumbersOfTheStreams) {
  const StreamKey key(1, "pairs");
  const Pairs<double> pairs = independent_pairs<double>(key);
  for (const std::uint64_t i : {std::uint64_t{0}, std::uint64_t{5}, std::uint64_t{6}, std::uint64_t{100},
                                (std::uint64_t{1} << 32) - 1, (std::uint64_t{1} << 32) + 3, std::uint64_t{5}}) {
    const Vec2<double> pair = pairs(i);
    PhiloxStream<double> stream(key, 0, i);
    EXPECT_EQ(pair.x(), stream.next()) << i;
    EXPECT_EQ(pair.y(), stream.next()) << i;
  }
}

// A replicate has all points of the set once, and the next one others.
TEST(PointPairs, AreOneReplicateAfterTheOther) {
  const StreamKey key(1, "points");
  const Pairs<double> pairs = point_pairs<double>(key, 4);
  std::array<bool, 4> quarters{};
  for (std::uint64_t i = 0; i < 4; ++i) quarters[static_cast<std::size_t>(4 * pairs(i).x())] = true;
  EXPECT_EQ(quarters, (std::array{true, true, true, true}));
  EXPECT_NE(pairs(0).x(), pairs(4).x());
  EXPECT_THROW(pairs(std::uint64_t{1} << 34), NoMoreDraws);
  EXPECT_THROW(point_pairs<Packet>(key, 2), std::invalid_argument);
}

// Uniform on [0,1) x [0,1), of which it says that a part has another density.
struct Stated {
  using Scalar = double;
  using Point = Vec2<double>;
  using Measure = Area;
  Vec2<double> sample(const Vec2<double>& u) const { return u; }
  Density<Area, double> pdf(const Vec2<double>& x) const {
    return Density<Area, double>(x.x() < part ? density : 1);
  }
  double part, density;
};

TEST(CheckDensity, RefusesADrawWithoutDensityOrOfAnother) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const auto verdict = [](const Stated& drawn, const Stated& law) {
    return check_density(trial, drawn, law).verdict;
  };
  EXPECT_EQ(verdict({0.5, 1}, {0.5, 1}), Verdict::certified);
  EXPECT_EQ(verdict({0.5, 0}, {0.5, 0}), Verdict::biased);
  EXPECT_EQ(verdict({0.5, infinite}, {0.5, infinite}), Verdict::biased);
  EXPECT_EQ(verdict({0.5, 1}, {0.5, 0}), Verdict::biased);
  EXPECT_EQ(verdict({0.5, 1.5}, {0.5, 1}), Verdict::biased);
}

}  // namespace
}  // namespace fairlight

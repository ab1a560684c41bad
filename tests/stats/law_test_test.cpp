#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include <fairlight/stats/chi_square.h>
#include <fairlight/stats/evidence.h>
#include <fairlight/stats/law_test.h>

// Draws that are laid out by hand, to show each way to fail.
namespace fairlight {
namespace {

const Trial trial{"law_test", 1, 1e-6, 0.01, 0.05};

using Counts = std::vector<std::uint64_t>;

LawCells even_cells(int n) { return {n, 1, std::vector<double>(static_cast<std::size_t>(n), 1.0 / n), 0}; }

// Counts n/16 each, but for deviations of eight tenths of a standard error up and down: a statistic of 10 where 15 are expected.
Counts plausible(std::uint64_t draws) {
  Counts counts(16, draws / 16);
  const auto deviation = static_cast<std::uint64_t>(0.8 * std::sqrt(static_cast<double>(draws) / 16));
  for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += i % 2 == 0 ? deviation : -deviation;
  counts[0] += draws % 16;
  return counts;
}

TEST(TestCounts, CertifiesCountsAsChanceMakesThem) {
  const Finding finding = test_counts(trial, even_cells(16), plausible);
  EXPECT_EQ(finding.verdict, Verdict::certified) << finding.note;
  EXPECT_EQ(finding.guarantee, Guarantee::asymptotic);
  EXPECT_TRUE(finding.note.starts_with("asymptotic: chi-square")) << finding.note;
  EXPECT_LT(finding.interval.hi, 0.05);
  EXPECT_EQ(finding.token, "0000000000000001");
}

TEST(TestCounts, FindsCountsThatAreTooGood) {
  const auto even = [](std::uint64_t draws) {
    Counts counts(16, draws / 16);
    counts[0] += draws % 16;
    return counts;
  };
  EXPECT_EQ(test_counts(trial, even_cells(16), even).verdict, Verdict::biased);
}

TEST(TestCounts, NamesTheOneCellThatIsWrong) {
  const auto one_off = [](std::uint64_t draws) {
    Counts counts = plausible(draws);
    const std::uint64_t moved = counts[3] / 5;
    counts[3] -= moved;
    counts[4] += moved;
    return counts;
  };
  const Finding finding = test_counts(trial, even_cells(16), one_off);
  EXPECT_EQ(finding.verdict, Verdict::biased);
  EXPECT_TRUE(finding.note.starts_with("cell 3 has ")) << finding.note;
}

// With so many looks, which share the rates evenly.
double most_draws(std::size_t cells, double looks) {
  return static_cast<double>(draws_to_tell_apart(cells, trial.margin, trial.alpha / 2 / looks, trial.beta / looks));
}

TEST(TestCounts, MayBeDoneAtTheFirstLook) {
  const Finding finding = test_counts(trial, even_cells(16), plausible);
  EXPECT_EQ(static_cast<double>(finding.draws), std::ceil(0.25 * most_draws(16, 4)));
}

// The first counts deviate by 1.4 standard errors each, a statistic of 31 where 15 are expected; the others not at all.
TEST(TestCounts, LooksAgainAtAllThatWasCounted) {
  std::vector<std::uint64_t> asked;
  const auto calmer = [&](std::uint64_t draws) {
    Counts counts(16, draws / 16);
    const double deviation = asked.empty() ? 1.4 * std::sqrt(static_cast<double>(draws) / 16) : 0;
    for (std::size_t i = 0; i < 16; i += 2) {
      counts[i] += static_cast<std::uint64_t>(deviation);
      counts[i + 1] -= static_cast<std::uint64_t>(deviation);
    }
    counts[0] += draws % 16;
    asked.push_back(draws);
    return counts;
  };
  Evidence evidence;
  Trial seen = trial;
  seen.evidence = &evidence;
  const Finding finding = test_counts(seen, even_cells(16), calmer);
  EXPECT_EQ(finding.verdict, Verdict::certified) << finding.note;
  ASSERT_EQ(asked.size(), 3u);
  EXPECT_EQ(static_cast<double>(finding.draws), std::ceil(0.5 * most_draws(16, 4)));
  EXPECT_EQ(finding.draws, asked[0] + asked[1] + asked[2]);
  ASSERT_EQ(evidence.laws.size(), 1u);
  const Counts& all = evidence.laws[0].counts;
  EXPECT_EQ(std::accumulate(all.begin(), all.end(), std::uint64_t{0}), finding.draws);
}

// A cell that expects 120 draws at the end expects 30, 42 and 60 before, where it would be pooled with its neighbour: there is one look.
TEST(TestCounts, DoesNotLookWhereCellsArePooledThatTheEndHasApart) {
  const double few = 120 / most_draws(16, 1);
  LawCells cells = even_cells(16);
  for (double& p : cells.probabilities) p = (1 - few) / 15;
  cells.probabilities[3] = few;
  const auto expected = [&](std::uint64_t draws) {
    Counts counts;
    for (double p : cells.probabilities)
      counts.push_back(static_cast<std::uint64_t>(p * static_cast<double>(draws)));
    counts[0] += draws - std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
    return counts;
  };
  EXPECT_EQ(static_cast<double>(test_counts(trial, cells, expected).draws), most_draws(16, 1));
}

TEST(TestCounts, RefusesCountsOfOtherCells) {
  for (std::size_t n : {15, 17}) {
    const Finding finding = test_counts(trial, even_cells(16), [&](std::uint64_t) { return Counts(n, 1); });
    EXPECT_EQ(finding.verdict, Verdict::biased);
    EXPECT_NE(finding.note.find("one count for each cell"), std::string::npos) << finding.note;
  }
}

TEST(TestCounts, RefusesAMarginThatNoCountCanReach) {
  Trial fine = trial;
  fine.margin = 1e-8;
  EXPECT_THROW(test_counts(fine, even_cells(16), plausible), std::invalid_argument);
}

TEST(TestCounts, RefusesCountsThatDoNotAddUp) {
  const auto short_of = [](std::uint64_t draws) { return plausible(draws / 2); };
  const Finding finding = test_counts(trial, even_cells(16), short_of);
  EXPECT_EQ(finding.verdict, Verdict::biased);
  EXPECT_NE(finding.note.find("do not add up"), std::string::npos) << finding.note;
}

TEST(TestCounts, RefusesProbabilitiesThatDoNotSumToOne) {
  LawCells cells = even_cells(16);
  cells.probabilities[0] += 0.1;
  const Finding finding = test_counts(trial, cells, plausible);
  EXPECT_EQ(finding.verdict, Verdict::biased);
  EXPECT_EQ(finding.guarantee, Guarantee::deterministic);
  EXPECT_NE(finding.note.find("integrates to 1.1"), std::string::npos) << finding.note;
}

TEST(LawCells, IntegrateADensityOverEachDomain) {
  const auto total = [](const LawCells& cells) {
    double sum = 0;
    for (double p : cells.probabilities) sum += p;
    return sum;
  };
  EXPECT_NEAR(total(law_cells(IntervalDomain{0, 2}, [](double x) { return x / 2; })), 1, 1e-9);
  EXPECT_NEAR(total(law_cells(DiskDomain{3}, [](const auto&) { return 1 / (9 * M_PI); })), 1, 1e-9);
  EXPECT_NEAR(total(law_cells(HemisphereDomain{}, [](const auto& w) { return w.z() / M_PI; })), 1, 1e-9);
  EXPECT_NEAR(total(law_cells(SphereDomain{2}, [](const auto&) { return 1 / (16 * M_PI); })), 1, 1e-9);
  EXPECT_NEAR(
      total(law_cells(DiscreteDomain{4}, [](std::int64_t i) { return (1.0 + static_cast<double>(i)) / 10; })), 1,
      1e-15);
}

TEST(TestLaw, FindsADensityThatIsSomewhereNegative) {
  const auto dips = [](double x) { return 1 + 1.5 * std::cos(2 * M_PI * x); };
  const Finding finding = test_law(trial, IntervalDomain{0, 1}, dips, [](std::uint64_t) { return 0.1; });
  EXPECT_EQ(finding.verdict, Verdict::biased);
  EXPECT_NE(finding.note.find("the density is -"), std::string::npos) << finding.note;
}

TEST(TestLaw, FindsADrawThatIsNoPoint) {
  const auto flat = [](const Eigen::Vector2d&) { return 1.0; };
  const Finding finding =
      test_law(trial, SquareDomain{0, 1}, flat, [](std::uint64_t) { return Eigen::Vector2d(0.5, std::nan("")); });
  EXPECT_EQ(finding.verdict, Verdict::biased);
  EXPECT_NE(finding.note.find("draw 0 is nan"), std::string::npos) << finding.note;
}

TEST(TestLaw, IsUndecidedWhereItCannotIntegrate) {
  const auto comb = [](double x) { return std::fmod(x * 1234.5, 1) < 0.5 ? 2.0 : 0.0; };
  EXPECT_EQ(test_law(trial, IntervalDomain{0, 1}, comb, [](std::uint64_t) { return 0.1; }).verdict,
            Verdict::undecided);
}

TEST(LawCells, RefuseADiscreteSetOfOne) {
  EXPECT_THROW(law_cells(DiscreteDomain{1}, [](std::int64_t) { return 1.0; }), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

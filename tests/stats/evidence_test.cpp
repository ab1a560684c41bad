#include <limits>

#include <gtest/gtest.h>

#include <fairlight/stats/evidence.h>
#include <fairlight/stats/law_test.h>
#include <fairlight/stats/mean_test.h>
#include <fairlight/stats/sequential_t_test.h>

namespace fairlight {
namespace {

const Trial trial{"evidence_test", 1, 1e-6, 0.01, 0.01};
const Reference half{.mean = 0.5, .lower = 0, .upper = 1};

// A fixed sequence of zeros and ones without pattern (Steele, Lea and Flood 2014, their mixer).
double coin(std::uint64_t i) {
  i = (i + 1) * 0x9E3779B97F4A7C15;
  i = (i ^ (i >> 30)) * 0xBF58476D1CE4E5B9;
  i = (i ^ (i >> 27)) * 0x94D049BB133111EB;
  return double(i >> 63);
}

void coins(std::uint64_t first, std::vector<std::vector<double>>& channels) {
  for (auto& channel : channels) {
    for (std::size_t i = 0; i < channel.size(); ++i) channel[i] = coin(first + i);
  }
}

void ones(std::uint64_t, std::vector<std::vector<double>>& channels) {
  channels[0].assign(channels[0].size(), 1.0);
}

Trial watched(Trial made, const std::function<bool(double)>& watch) {
  made.watch = watch;
  return made;
}

std::vector<std::uint64_t> even_counts(std::uint64_t draws) {
  std::vector<std::uint64_t> counts(4, draws / 4);
  counts[0] += draws % 4;
  return counts;
}

TEST(Evidence, IsTheCourseOfEveryChannelUpToItsVerdict) {
  Evidence evidence;
  Trial seen = trial;
  seen.evidence = &evidence;
  const Finding finding = test_means(seen, {half, half}, coins);
  ASSERT_EQ(finding.verdict, Verdict::certified);
  ASSERT_EQ(evidence.means.size(), 2u);
  const auto& last = evidence.means[1].steps().back();
  EXPECT_EQ(last.draws, finding.draws);
  EXPECT_GE(last.wealth.below_upper_margin, evidence.means[1].certifying());
  EXPECT_GE(last.wealth.above_lower_margin, evidence.means[1].certifying());
  EXPECT_LT(last.wealth.above_reference, evidence.means[1].refuting());
}

TEST(Evidence, ShowsTheWealthThatRefutes) {
  Evidence evidence;
  Trial seen = trial;
  seen.evidence = &evidence;
  ASSERT_EQ(test_means(seen, {half}, ones).verdict, Verdict::biased);
  EXPECT_GE(evidence.means[0].steps().back().wealth.above_reference, evidence.means[0].refuting());
  EXPECT_EQ(evidence.means[0].steps().back().mean, 1);
}

TEST(Evidence, ChangesNoFinding) {
  Evidence evidence;
  Trial seen = watched(trial, [](double) { return true; });
  seen.evidence = &evidence;
  const Finding with = test_means(seen, {half}, coins);
  const Finding without = test_means(trial, {half}, coins);
  EXPECT_EQ(with.draws, without.draws);
  EXPECT_EQ(with.interval.lo, without.interval.lo);
}

// A test of coins in two channels, and the draws that it made, by channel.
std::vector<std::vector<double>> tested(Evidence& evidence, const DrawBlock& draw_block) {
  std::vector<std::vector<double>> draws(2);
  Trial seen = trial;
  seen.evidence = &evidence;
  bool over = false;
  const auto listener = evidence.listener;
  evidence.listener = [&](const std::vector<Reference>& references, const DrawBlock& again, std::uint64_t n) {
    over = true;
    listener(references, again, n);
  };
  test_means(seen, {half, half}, [&](std::uint64_t first, std::vector<std::vector<double>>& channels) {
    draw_block(first, channels);
    for (std::size_t c = 0; c < 2 && !over; ++c) {
      draws[c].insert(draws[c].end(), channels[c].begin(), channels[c].end());
    }
  });
  return draws;
}

TEST(Evidence, TellsAListenerTheVeryDrawsThatWereTested) {
  std::vector<std::vector<double>> heard(2);
  Evidence evidence;
  evidence.listener = [&](const std::vector<Reference>& references, const DrawBlock& again, std::uint64_t n) {
    EXPECT_EQ(references.size(), 2u);
    EXPECT_EQ(references[1].mean, 0.5);
    for (auto& channel : heard) channel.resize(n);
    again(0, heard);
  };
  const auto draws = tested(evidence, coins);
  EXPECT_GT(draws[0].size(), 100u);
  EXPECT_EQ(heard, draws);
}

TEST(Evidence, TellsAListenerOfADrawThatIsRuledOutToo) {
  std::uint64_t heard = 0;
  Evidence evidence;
  evidence.listener = [&](const std::vector<Reference>&, const DrawBlock&, std::uint64_t n) { heard = n; };
  tested(evidence, [](std::uint64_t first, std::vector<std::vector<double>>& channels) {
    coins(first, channels);
    if (first <= 30 && 30 < first + channels[0].size()) channels[0][30 - first] = 2;
  });
  EXPECT_EQ(heard, 31u) << "draws up to the one above its range";
}

TEST(Evidence, KeepsAFewHundredStepsInOrder) {
  BettingTest test({.mean = 0.5, .margin = 1e-6, .lower = 0, .upper = 1}, 1e-6, 0.01);
  Evidence::Course course(test);
  for (int i = 0; i < 100'000; ++i) {
    test.add(std::vector<double>{double(i % 2)});
    course.add(test);
  }
  EXPECT_LE(course.steps().size(), 512u);
  EXPECT_GE(course.steps().size(), 256u);
  EXPECT_EQ(course.steps().back().draws, 100'000u);
  for (std::size_t i = 1; i < course.steps().size(); ++i) {
    EXPECT_GT(course.steps()[i].draws, course.steps()[i - 1].draws);
  }
}

TEST(Evidence, HoldsTheCountsOfALaw) {
  Evidence evidence;
  Trial seen = trial;
  seen.evidence = &evidence;
  test_counts(seen, {2, 2, {0.25, 0.25, 0.25, 0.25}, 0}, even_counts);
  ASSERT_EQ(evidence.laws.size(), 1u);
  EXPECT_EQ(evidence.laws[0].rows, 2);
  EXPECT_EQ(evidence.laws[0].counts, even_counts(static_cast<std::uint64_t>(evidence.laws[0].draws)));
}

TEST(CellTails, AreThoseOfTheBinomialLaw) {
  const CellTails none = cell_tails(0, 10, 0.5);
  EXPECT_DOUBLE_EQ(none.too_few, std::pow(0.5, 10));
  EXPECT_EQ(none.too_many, 1);
  EXPECT_DOUBLE_EQ(cell_tails(10, 10, 0.5).too_many, std::pow(0.5, 10));
  EXPECT_EQ(cell_tails(1, 10, 0).too_many, 0);
  EXPECT_EQ(cell_tails(0, 10, 0).too_many, 1);
}

TEST(Watch, IsToldHowMuchIsDoneAndThatGrows) {
  double before = 0;
  const auto watch = [&](double done) {
    EXPECT_GT(done, 0);
    EXPECT_LT(done, 1);
    EXPECT_GE(done, before);
    before = done;
    return true;
  };
  test_means(watched(trial, watch), {half}, coins);
  EXPECT_GT(before, 0.5);
}

TEST(Watch, EndsATestOfMeansUndecidedWithAnIntervalThatHolds) {
  const Finding finding = test_means(watched(trial, [](double done) { return done < 0.3; }), {half}, coins);
  EXPECT_EQ(finding.verdict, Verdict::undecided);
  EXPECT_EQ(finding.note, told_to_end);
  EXPECT_GT(finding.draws, 0u);
  EXPECT_LE(finding.interval.lo, 0);
  EXPECT_GE(finding.interval.hi, 0);
  EXPECT_GT(finding.interval.hi, trial.margin);
}

TEST(TestMeans, AreUndecidedWhereThereAreNoMoreDrawsAndKeepWhatTheySaw) {
  Evidence evidence;
  Trial seen = trial;
  seen.evidence = &evidence;
  const auto few_coins = [](std::uint64_t first, std::vector<std::vector<double>>& channels) {
    if (first + channels[0].size() > 2000) throw NoMoreDraws("the coins have run out");
    coins(first, channels);
  };
  const Finding finding = test_means(seen, {half}, few_coins);
  EXPECT_EQ(finding.verdict, Verdict::undecided);
  EXPECT_EQ(finding.note.find("the coins have run out; a verdict needs about "), 0u) << finding.note;
  EXPECT_GT(finding.draws, 0u);
  EXPECT_LE(finding.draws, 2000u);
  EXPECT_LT(finding.interval.hi, 1);
  EXPECT_EQ(evidence.means[0].steps().back().draws, finding.draws);
  EXPECT_EQ(evidence.margin_grid.channels.size(), 1u);
}

TEST(Watch, EndsATestOfALawUndecided) {
  const Finding finding = test_law(
      watched(trial, [](double) { return false; }), IntervalDomain{0, 1}, [](double) { return 1.0; }, coin);
  EXPECT_EQ(finding.verdict, Verdict::undecided);
  EXPECT_EQ(finding.note, told_to_end);
  EXPECT_EQ(finding.interval.hi, std::numeric_limits<double>::infinity());
}

TEST(Watch, EndsAStudentTestUndecided) {
  const Finding finding = sequential_t_test(watched(trial, [](double) { return false; }), 0.5, 0.5, coins);
  EXPECT_EQ(finding.verdict, Verdict::undecided);
  EXPECT_EQ(finding.note, told_to_end);
}

}  // namespace
}  // namespace fairlight

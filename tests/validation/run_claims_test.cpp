#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include <fairlight/validation/run/forecast.h>
#include <fairlight/validation/run/registry.h>
#include <fairlight/validation/run/run_claims.h>

namespace fairlight {
namespace {

const RunOptions quick{{.seed = 3, .margin = 0.01}, 1};

TEST(ManifestOf, GivesAClaimItsShareWhateverElseRuns) {
  double sum = 0;
  const Manifest manifest = manifest_of(quick);
  for (const Claim& claim : registry()) sum += manifest.trial(claim.name).alpha;
  EXPECT_NEAR(sum, 0.9e-6, 1e-18) << "a tenth is for components";
}

TEST(ManifestOf, RefusesAClaimOutsideTheRegistry) {
  EXPECT_THROW(manifest_of(quick).trial("nobody.claims.this"), std::invalid_argument);
}

TEST(ManifestOf, RefusesMarginsAndBudgetsThatAreNoProbability) {
  for (double margin : {0.0, -1.0, 1.0, 5.0}) {
    RunOptions wrong = quick;
    wrong.terms.margin = margin;
    EXPECT_THROW(manifest_of(wrong).trial(registry()[0].name), std::invalid_argument) << margin;
  }
  for (double budget : {0.0, 1.0, -1.0}) {
    RunOptions wrong = quick;
    wrong.terms.budget = budget;
    EXPECT_THROW(manifest_of(wrong).trial(registry()[0].name), std::invalid_argument) << budget;
  }
}

TEST(RunClaims, FindTheSameAloneOrTogetherOnAnyThreads) {
  const auto together = select_claims({"pick.*.dice", "importance.cosine"});
  RunOptions two = quick;
  two.threads = 2;
  const auto outcomes = run_claims(together, two);
  for (std::size_t i = 0; i < together.size(); ++i) {
    const Finding alone = run_claims({together[i]}, quick).front().finding;
    EXPECT_EQ(alone.draws, outcomes[i].finding.draws) << together[i]->name;
    EXPECT_EQ(alone.bias, outcomes[i].finding.bias) << together[i]->name;
  }
}

TEST(RunClaims, FindTheSameWhateverTheTimeThatIsLeft) {
  const auto claims = select_claims({"pick.*.dice", "importance.cosine"});
  RunOptions limited = quick;
  limited.seconds = 1000;
  limited.evidence = true;
  const auto outcomes = run_claims(claims, limited);
  const auto usual = run_claims(claims, quick);
  for (std::size_t i = 0; i < claims.size(); ++i) {
    EXPECT_EQ(usual[i].claim, claims[i]);
    EXPECT_EQ(usual[i].finding.draws, outcomes[i].finding.draws) << claims[i]->name;
    EXPECT_EQ(usual[i].finding.interval.hi, outcomes[i].finding.interval.hi) << claims[i]->name;
    EXPECT_FALSE(outcomes[i].out_of_time);
    EXPECT_FALSE(outcomes[i].evidence.means.empty());
    EXPECT_TRUE(usual[i].evidence.means.empty()) << "what nobody asked for";
  }
}

TEST(RunClaims, LeaveUndecidedWhatHasNoVerdictWhenTheTimeIsUp) {
  RunOptions hurried = quick;
  hurried.terms.margin = 3e-5;  // hours
  hurried.seconds = 0.2;
  const auto outcomes = run_claims(select_claims({"furnace.bounce", "furnace.light"}), hurried);
  for (const Outcome& outcome : outcomes) {
    EXPECT_EQ(outcome.finding.verdict, Verdict::undecided) << outcome.claim->name;
    EXPECT_TRUE(outcome.out_of_time);
    EXPECT_NE(outcome.finding.note.find("time was up"), std::string::npos);
    EXPECT_LE(outcome.finding.interval.lo, 0);
    EXPECT_GE(outcome.finding.interval.hi, 3e-5);
  }
}

TEST(RunClaims, LeaveUndecidedWhatHasNoTurn) {
  RunOptions hurried = quick;
  hurried.seconds = 1e-9;
  const Outcome outcome = run_claims(select_claims({"pick.one.dice"}), hurried).front();
  EXPECT_EQ(outcome.finding.verdict, Verdict::undecided);
  EXPECT_TRUE(outcome.out_of_time);
  EXPECT_EQ(outcome.finding.draws, 0u);
  EXPECT_EQ(outcome.finding.interval.hi, std::numeric_limits<double>::infinity());
}

TEST(RunClaims, RefuseATimeThatIsNone) {
  for (double seconds : {0.0, -1.0, std::nan("")}) {
    RunOptions wrong = quick;
    wrong.seconds = seconds;
    EXPECT_THROW(run_claims({}, wrong), std::invalid_argument) << seconds;
  }
}

// A claim that takes some time in its first turn, where it is at `first` and then at `second` of the whole. That turn ends there, unless the
// verdict is near; a second is short.
Claim slow_claim(const Claim& row, double first, double second, Interval interval,
                 std::vector<std::string>& order) {
  Claim claim = row;
  claim.check = [=, &order, turns = std::make_shared<int>(0)](const Trial& trial) {
    Finding finding{Verdict::certified};
    if (++*turns > 1) {
      order.push_back(trial.claim);
      return finding;
    }
    EXPECT_TRUE(goes_on(trial, first));
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    if (goes_on(trial, second)) {
      order.push_back("at once " + trial.claim);
      return finding;
    }
    finding.verdict = Verdict::undecided;
    finding.interval = interval;
    return finding;
  };
  return claim;
}

TEST(RunClaims, TakeTheLongestFirstAndInHasteWhatLooksWrongThenTheShortest) {
  const std::vector<Claim>& rows = registry();
  for (const double seconds : {std::numeric_limits<double>::infinity(), 1000.0}) {
    std::vector<std::string> order;
    const Claim middle = slow_claim(rows[0], 0.01, 0.02, {-1, 1}, order);
    const Claim shortest = slow_claim(rows[1], 0.5, 0.9, {-1, 1}, order);
    const Claim longest = slow_claim(rows[2], 1e-5, 2e-5, {0.1, 0.2}, order);
    RunOptions run_options = quick;
    run_options.seconds = seconds;
    run_claims({&middle, &shortest, &longest}, run_options);
    const std::vector<std::string> usual{"at once " + rows[1].name, rows[2].name, rows[0].name};
    const std::vector<std::string> hasty{rows[2].name, rows[1].name, rows[0].name};
    EXPECT_EQ(order, seconds == 1000 ? hasty : usual);
  }
}

TEST(RunClaims, StopAtTheFirstFailureIfAsked) {
  const std::vector<Claim>& rows = registry();
  Claim bad = rows[0], good = rows[1];
  bad.check = [](const Trial&) { return Finding{Verdict::biased}; };
  int runs = 0;
  good.check = [&runs](const Trial&) {
    ++runs;
    return Finding{Verdict::certified};
  };
  RunOptions run_options = quick;
  EXPECT_FALSE(run_claims({&bad, &good}, run_options)[1].out_of_time);
  EXPECT_EQ(runs, 1);
  run_options.fail_fast = true;
  EXPECT_TRUE(run_claims({&bad, &good}, run_options)[1].out_of_time);
  EXPECT_EQ(runs, 1);
  EXPECT_FALSE(run_claims({&good, &bad}, run_options)[0].out_of_time) << "it ran before";
}

TEST(RunClaims, SayWhichClaimRefusesItsTerms) {
  Claim claim = registry()[0];
  claim.check = [](const Trial&) -> Finding { throw std::invalid_argument("why so"); };
  try {
    run_claims({&claim}, quick);
    FAIL() << "it must throw";
  } catch (const std::invalid_argument& refused) {
    EXPECT_NE(std::string(refused.what()).find(claim.name), std::string::npos);
    EXPECT_NE(std::string(refused.what()).find("(why so)"), std::string::npos);
  }
}

TEST(RunClaims, ProgressFromNothingToTheEnd) {
  std::vector<double> told;
  run_claims(select_claims({"pick.*.dice", "importance.cosine"}), quick,
             [&](double done) { told.push_back(done); });
  ASSERT_FALSE(told.empty());
  for (std::size_t i = 0; i + 1 < told.size(); ++i) {
    EXPECT_GT(told[i], 0);
    EXPECT_LT(told[i], 1);
  }
  EXPECT_EQ(told.back(), 1);
}

TEST(Forecast, IsThePartOfAllSecondsThatIsSpent) {
  Forecast forecast(4);
  EXPECT_EQ(forecast.done(), 0);
  forecast.set(0, 1, 0);
  forecast.set(1, 1, 8);
  EXPECT_DOUBLE_EQ(forecast.done(), 0.1) << "two of four parts take ten seconds, so all take twenty; two are spent";
  forecast.set(2, 0, 5);
  forecast.set(3, 0, 5);
  EXPECT_DOUBLE_EQ(forecast.done(), 0.1);
  EXPECT_EQ(forecast.left(1), 8);
}

TEST(Failed, IsWhatIsBiasedOrUndecidedThoughThereWasTime) {
  Outcome outcome{&registry()[0], {}, 0};
  for (const bool late : {false, true}) {
    outcome.out_of_time = late;
    outcome.finding.verdict = Verdict::certified;
    EXPECT_FALSE(failed(outcome));
    outcome.finding.verdict = Verdict::biased;
    EXPECT_TRUE(failed(outcome)) << "by the ledger, if not in time";
    outcome.finding.verdict = Verdict::undecided;
    EXPECT_EQ(failed(outcome), !late);
  }
}

TEST(Overall, IsTheWorst) {
  Outcome good{&registry()[0], {}, 0};
  good.finding.verdict = Verdict::certified;
  Outcome bad = good;
  bad.finding.verdict = Verdict::biased;
  EXPECT_EQ(overall({good, good}), Verdict::certified);
  EXPECT_EQ(overall({good, bad}), Verdict::biased);
}

}  // namespace
}  // namespace fairlight

#include <cmath>
#include <random>

#include <boost/math/distributions/binomial.hpp>
#include <gtest/gtest.h>

#include <fairlight/stats/mean_test.h>
#include <fairlight/stats/plan.h>
#include <fairlight/stats/seed.h>

namespace fairlight {
namespace {

const MeanPlan plan{0.5, 0, 1, 1 / std::sqrt(12.0), 0.5};

TEST(Plan, AnswersBothQuestionsAlike) {
  const PlannedDraws draws = planned_draws(plan, 1e-3);
  EXPECT_NEAR(planned_margin(plan, draws.expected).expected, 1e-3, 1e-12);
  EXPECT_NEAR(planned_margin(plan, draws.with_99_percent).with_99_percent, 1e-3, 1e-12);
  EXPECT_GT(draws.with_99_percent, draws.expected);
}

// Without variance each draw multiplies the wealth by 1 + 0.9 m / room: 1.1 ln(100) / 0.9 = 5.6.
TEST(Plan, ADrawWithoutVarianceIsLimitedByItsRange) {
  const MeanPlan still{0.5, 0, 4, 0, 0.5};
  EXPECT_NEAR(planned_draws(still, 0.01).expected, 5.6285 * 3.5 / 0.005, 1);
}

TEST(Plan, RefusesWhatCannotBeTested) {
  const auto refuses = [](const MeanPlan& p, double margin) {
    EXPECT_THROW(planned_draws(p, margin), std::invalid_argument);
  };
  refuses({0.5, 0, 1, 0.51, 0.5}, 1e-3);  // at most 0.5 in this range
  refuses({1, 0, 1, 0, 1}, 1e-3);
  refuses({0, -1, 1, 0.1, 0}, 1e-3);
  refuses({0.5, 0, 1, 0.1, 0.5, 1}, 1e-3);
  refuses(plan, 0);
  refuses(plan, 1.5);
  refuses(plan, std::nan(""));
  EXPECT_THROW(planned_margin(plan, 0), std::invalid_argument);
  EXPECT_THROW(planned_margin(plan, std::nan("")), std::invalid_argument);
}

// Runs later than planned with 99 % are inside the binomial limit of 1 %, at level 1e-6: with 300
// runs, a plan that is late in 10 % of them passes with probability 1e-3. The average is within a
// fifth of the plan: a run's draws vary by 0.6 of their mean, so that the average of 300 runs
// varies by 3.5 %, and 15 % beside the 5 % of the formula are more than four of its deviations.
TEST(Plan, TheTestTakesThePlannedDraws) {
  constexpr int runs = 300;
  constexpr double margin = 0.02;
  const std::uint64_t seed = fresh_seed();
  SCOPED_TRACE(seed_text(seed));
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  const PlannedDraws planned = planned_draws(plan, margin);
  double sum = 0;
  int late = 0;
  for (int run = 0; run < runs; ++run) {
    const Finding finding =
        test_mean({"plan", seed, 1e-6, plan.beta, margin}, {0.5, 0, 1}, [&] { return uniform(generator); });
    sum += static_cast<double>(finding.draws);
    late += static_cast<double>(finding.draws) > planned.with_99_percent;
  }
  const boost::math::binomial law(runs, 0.01);
  EXPECT_GT(cdf(complement(law, late - 1)), 1e-6) << late << " late runs";
  EXPECT_LT(std::abs(sum / runs / planned.expected - 1), 0.2) << sum / runs << ", planned " << planned.expected;
}

}  // namespace
}  // namespace fairlight

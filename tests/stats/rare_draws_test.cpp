#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <fairlight/stats/googletest.h>

// Estimators whose mean comes in part in draws that a test may not meet, and draws that cannot be, in a pilot.
namespace fairlight {
namespace {

double uniform(Generator& generator) { return static_cast<double>(generator() >> 11) * 0x1p-53; }

bool biased(const Expectation& expectation) { return expectation.message.starts_with("biased"); }

TEST(RareDraws, AreNoBiasBeforeTheyAreMet) {
  const auto quiet = [](Generator& g) { return 1 + 0.2 * (uniform(g) - 0.5); };
  const auto half_rare = [](Generator& g) {
    return 0.5 + 0.1 * (uniform(g) - 0.5) + (uniform(g) < 1e-5 ? 0.5e5 : 0);
  };
  const auto one_less = [&](Generator& g) { return 2 - half_rare(g); };
  const Limits limits{.seconds = 2};
  EXPECT_FALSE(biased(expect_agree(googletest_site(), quiet, half_rare, 0.05, limits)));
  EXPECT_FALSE(biased(expect_agree(googletest_site(), half_rare, quiet, 0.05, limits)));
  EXPECT_FALSE(biased(expect_agree(googletest_site(), one_less, quiet, 0.05, limits)));
  EXPECT_FALSE(biased(expect_unbiased(googletest_site(), half_rare, 1.0, 0.05, limits)));
  EXPECT_FALSE(biased(expect_unbiased(googletest_site(), one_less, 1.0, 0.05, limits)));
  EXPECT_FALSE(biased(expect_unbiased(googletest_site(), half_rare, nonnegative(1), 0.05, limits)));
  EXPECT_FALSE(biased(expect_at_least(googletest_site(), half_rare, 1.0, 0.05, limits)));
}

TEST(RareDraws, AreMetByThePilot) {
  for (double p : {1e-2, 1e-3, 1e-4}) {
    const auto event = [p](Generator& g) { return uniform(g) < p; };
    const Expectation found = expect_unbiased(googletest_site(), event, p, 0.3);
    EXPECT_TRUE(found.met) << p << "\n" << found.message;
  }
}

TEST(RareDraws, ThatNoPilotCanMeetEndUndecidedWithWhatToDeclare) {
  const auto event = [](Generator& g) { return uniform(g) < 1e-9; };
  const Expectation found = expect_unbiased(googletest_site(), event, 1e-9, 0.3, Limits{.draws = 1e6});
  EXPECT_TRUE(found.message.starts_with("undecided")) << found.message;
  EXPECT_NE(found.message.find("declare a range"), std::string::npos) << found.message;
}

// The draws number 1000 of any estimator are drawn by its pilot.
TEST(DrawsThatCannotBe, AreFoundInAPilot) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double wrong : {nan, std::numeric_limits<double>::infinity(), 2.0}) {
    const auto broken = [wrong] {
      return [wrong, drawn = 0](Generator& g) mutable { return ++drawn == 1000 ? wrong : uniform(g); };
    };
    const auto found = [&](const Expectation& e) {
      EXPECT_TRUE(biased(e) && e.message.find("draw 999 is ") != std::string::npos) << e.message;
    };
    found(expect_agree(googletest_site(), in_range(uniform, 0, 1), in_range(broken(), 0, 1), 0.05));
    found(expect_unbiased(googletest_site(), broken(), bounded(0.5, 0, 1), 0.02));
    if (wrong == 2) continue;
    found(expect_agree(googletest_site(), uniform, broken(), 0.05));
    found(expect_agree(googletest_site(), broken(), uniform, 0.05));
    found(expect_unbiased(googletest_site(), broken(), 0.5, 0.05));
    found(expect_unbiased(googletest_site(), broken(), finite_variance(0.5, 1. / 12), 0.01));
  }
}

}  // namespace
}  // namespace fairlight

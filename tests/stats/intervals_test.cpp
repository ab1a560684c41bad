#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include <fairlight/stats/googletest.h>

namespace fairlight {
namespace {

// The mean of sixteen normal draws of mean 3, with a stated standard error.
Estimate mean_of_sixteen(Generator& generator, double stated) {
  std::normal_distribution<> normal(3, 1);
  double sum = 0;
  for (int i = 0; i < 16; ++i) sum += normal(generator);
  return {sum / 16, stated};
}

TEST(Intervals, ThatCoverAsTheySayAreCertified) {
  const auto right = [](Generator& g) { return mean_of_sixteen(g, 0.25); };
  EXPECT_INTERVALS(right, 3, 0.95, 0.2);
  EXPECT_INTERVALS(right, 3, 0.5);
  const auto ends = [&](Generator& g) {
    const Estimate estimate = right(g);
    return Interval{estimate.value - 0.25, estimate.value + 0.25};
  };
  EXPECT_INTERVALS(ends, 3, std::erf(std::sqrt(0.5)), 0.1);
}

TEST(Intervals, ThatAreTooShortOrTooLongAreFound) {
  for (double stated : {0.2, 0.32}) {
    const auto wrong = [=](Generator& g) { return mean_of_sixteen(g, stated); };
    const Expectation found = expect_intervals(googletest_site(), wrong, 3);
    EXPECT_TRUE(found.message.starts_with("biased: the rate at which intervals miss 3")) << found.message;
    EXPECT_NE(found.message.find(", exact"), std::string::npos) << found.message;
  }
}

TEST(Intervals, ThatAreNoneAreFound) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Interval& none : {Interval{nan, 1}, Interval{0, nan}, Interval{1, 0}}) {
    const auto wrong = [=](Generator&) { return none; };
    EXPECT_NE(expect_intervals(googletest_site(), wrong, 0.5).message.find("draw 0 is nan"), std::string::npos);
  }
  const auto right = [](Generator& g) { return mean_of_sixteen(g, 0.25); };
  for (double level : {0.0, 1.0, nan})
    EXPECT_THROW(expect_intervals(googletest_site(), right, 3, level), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

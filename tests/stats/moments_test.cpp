#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/stats/moments.h>

namespace fairlight {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Moments, OfThreeNumbers) {
  const std::vector<double> draws{1, 2, 6};
  const Moments moments = Moments::of(draws);
  EXPECT_EQ(moments.count(), 3u);
  EXPECT_EQ(moments.mean(), 3);
  EXPECT_EQ(moments.squared_deviations(), 4 + 1 + 9);
  EXPECT_EQ(moments.variance(), 7);
}

TEST(Moments, NeedTwoDrawsForAVariance) {
  const std::vector<double> one{4};
  EXPECT_THROW((void)Moments::of(one).variance(), std::logic_error);
}

TEST(Moments, KeepASmallVarianceOnALargeMean) {
  Moments all;
  for (int i = 0; i < 1000; ++i) {
    const std::vector<double> block{1e9 - 1, 1e9 + 1};
    all.merge(Moments::of(block));
  }
  EXPECT_EQ(all.mean(), 1e9);
  EXPECT_EQ(all.squared_deviations(), 2000);
}

// 0, 0, 0, 4: deviations -1, -1, -1, 3.
TEST(Moments, OfTheThirdAndFourthOrder) {
  const std::vector<double> draws{0, 0, 0, 4};
  const Moments moments = Moments::of(draws);
  EXPECT_EQ(moments.minimum(), 0);
  EXPECT_EQ(moments.maximum(), 4);
  EXPECT_DOUBLE_EQ(moments.skewness(), 2 * 24 / std::pow(12, 1.5));
  EXPECT_DOUBLE_EQ(moments.variance_of_variance(), 84.0 / 144 - 0.25);
  EXPECT_DOUBLE_EQ(moments.standard_error(), 1);
}

TEST(Moments, OfEqualDrawsHaveNoShape) {
  const std::vector<double> draws{0.1, 0.1, 0.1};  // whose sum is not 0.3
  EXPECT_EQ(Moments::of(draws).mean(), 0.1);
  EXPECT_EQ(Moments::of(draws).variance(), 0);
  EXPECT_EQ(Moments::of(draws).skewness(), 0);
  EXPECT_EQ(Moments::of(draws).variance_of_variance(), 0);
}

TEST(Moments, ShowANumberThatIsNone) {
  for (std::size_t bad = 0; bad < 19; ++bad) {  // in the first eight, the last, and the rest
    std::vector<double> draws(19, 1.0);
    draws[bad] = std::nan("");
    const Moments moments = Moments::of(draws);
    EXPECT_TRUE(std::isnan(moments.minimum()) && std::isnan(moments.maximum()) && std::isnan(moments.mean()));
    for (bool first : {true, false}) {  // whichever part has it
      Moments whole = first ? moments : Moments::of(std::vector(5, 1.0));
      whole.merge(first ? Moments::of(std::vector(5, 1.0)) : moments);
      EXPECT_TRUE(std::isnan(whole.minimum()) && std::isnan(whole.maximum()) && std::isnan(whole.mean())) << first;
    }
  }
}

TEST(Moments, HaveTheirExtremesAnywhere) {
  for (std::size_t place = 0; place < 19; ++place) {
    std::vector<double> draws(19, 1.0);
    draws[place] = -3;
    EXPECT_EQ(Moments::of(draws).minimum(), -3);
    draws[place] = infinity;
    EXPECT_EQ(Moments::of(draws).maximum(), infinity);
  }
}

// 2^40 draws of 0 and 1, by doubling: mean 1/2, variance 1/4, no skewness, fourth moment 1/16.
TEST(Moments, AreStableForATrillionDraws) {
  const std::vector<double> pair{0, 1};
  Moments all = Moments::of(pair);
  for (int i = 1; i < 40; ++i) all.merge(Moments(all));
  EXPECT_EQ(all.count(), std::uint64_t{1} << 40);
  EXPECT_EQ(all.mean(), 0.5);
  EXPECT_DOUBLE_EQ(all.variance(), 0.25 / (1 - 0x1p-40));
  EXPECT_EQ(all.skewness(), 0);
  EXPECT_NEAR(all.variance_of_variance(), 0, 1e-26);
}

// The same draws, one block at a time onto a sum of 10^12.
TEST(Moments, DoNotStallWhenABlockMeetsATrillion) {
  const std::vector<double> pair{0, 1};
  Moments all = Moments::of(pair);
  for (int i = 1; i < 40; ++i) all.merge(Moments(all));
  const std::vector<double> block{2, 2};
  const auto n = static_cast<double>(all.count());
  for (int i = 0; i < 1000; ++i) all.merge(Moments::of(block));
  EXPECT_NEAR(all.mean() - 0.5, 1.5 * 2000 / (n + 2000), 1e-13);
  EXPECT_EQ(all.maximum(), 2);
}

RC_GTEST_PROP(Moments, MergingIsCountingTogether, (std::vector<int> a, std::vector<int> b)) {
  const std::vector<double> first(a.begin(), a.end());
  const std::vector<double> second(b.begin(), b.end());
  std::vector<double> both = first;
  both.insert(both.end(), second.begin(), second.end());
  Moments merged = Moments::of(first);
  merged.merge(Moments::of(second));
  const Moments whole = Moments::of(both);
  RC_ASSERT(merged.count() == whole.count());
  RC_PRE(whole.count() > 0u);
  RC_ASSERT(merged.minimum() == whole.minimum() && merged.maximum() == whole.maximum());
  RC_ASSERT(std::abs(merged.skewness() - whole.skewness()) <= 1e-9 * (1 + std::abs(whole.skewness())));
  RC_ASSERT(std::abs(merged.variance_of_variance() - whole.variance_of_variance()) <= 1e-9);
  RC_ASSERT(std::abs(merged.mean() - whole.mean()) <= 1e-12 * (1 + std::abs(whole.mean()) * 1e3));
  RC_ASSERT(std::abs(merged.squared_deviations() - whole.squared_deviations()) <=
            1e-9 * (1 + whole.squared_deviations()));
}

}  // namespace
}  // namespace fairlight

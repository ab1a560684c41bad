#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/stats/moments.h>

namespace fairlight {
namespace {

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

RC_GTEST_PROP(Moments, MergingIsCountingTogether, (std::vector<int> a, std::vector<int> b)) {
  const std::vector<double> first(a.begin(), a.end());
  const std::vector<double> second(b.begin(), b.end());
  std::vector<double> both = first;
  both.insert(both.end(), second.begin(), second.end());
  Moments merged = Moments::of(first);
  merged.merge(Moments::of(second));
  const Moments whole = Moments::of(both);
  RC_ASSERT(merged.count() == whole.count());
  RC_ASSERT(std::abs(merged.mean() - whole.mean()) <= 1e-12 * (1 + std::abs(whole.mean()) * 1e3));
  RC_ASSERT(std::abs(merged.squared_deviations() - whole.squared_deviations()) <=
            1e-9 * (1 + whole.squared_deviations()));
}

}  // namespace
}  // namespace fairlight

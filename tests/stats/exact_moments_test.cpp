#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/stats/exact_moments.h>

namespace fairlight {
namespace {

ExactMoments moments_of(const std::vector<double>& draws) {
  ExactMoments moments;
  for (double x : draws) moments.add(x);
  return moments;
}

TEST(ExactMoments, OfThreeNumbers) {
  const ExactMoments moments = moments_of({1, 2, 6});
  EXPECT_EQ(moments.count(), 3u);
  EXPECT_EQ(moments.mean(), 3);
  EXPECT_EQ(moments.variance(), 7);
  EXPECT_EQ(moments.standard_error(), std::sqrt(7.0 / 3));
}

TEST(ExactMoments, LoseNothingBetweenLargeAndSmall) {
  const ExactMoments moments = moments_of({0x1p60, 0x1p-90});
  const ExactMoments large = moments_of({0x1p60, 0});
  EXPECT_NE(moments, large);
  EXPECT_EQ(moments.words()[1], std::uint64_t{1} << 6);                // 2^-90 is 2^6 units of 2^-96
  EXPECT_EQ(moments.words()[3], std::uint64_t{1} << (60 + 96 - 128));  // 2^60 is 2^156 of them
}

TEST(ExactMoments, OfEqualDrawsHaveNoVarianceAtAll) {
  EXPECT_EQ(moments_of(std::vector<double>(1000, 0.1)).variance(), 0);
  EXPECT_EQ(moments_of(std::vector<double>(7, 1e-30)).variance(), 0);
}

TEST(ExactMoments, BelowTwoDrawsKnowNoVariance) {
  EXPECT_EQ(ExactMoments().mean(), 0);
  EXPECT_EQ(ExactMoments().standard_error(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(moments_of({5}).variance(), std::numeric_limits<double>::infinity());
}

TEST(ExactMoments, RoundADrawBelowTheUnitHalfToEven) {
  EXPECT_EQ(moments_of({0x1p-97}).words()[1], 0u);
  EXPECT_EQ(moments_of({0x1.8p-96}).words()[1], 2u);
  EXPECT_EQ(moments_of({0x1.4p-96}).words()[1], 1u);
  EXPECT_EQ(moments_of({std::numeric_limits<double>::denorm_min()}).count(), 1u);
}

TEST(ExactMoments, RefuseWhatIsNoDraw) {
  ExactMoments moments;
  for (double x :
       {-1e-300, -1.0, 0x1p64, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(moments.add(x), std::domain_error) << x;
  }
  EXPECT_EQ(moments, ExactMoments());
}

TEST(ExactMoments, SayWhenTheSumOverflows) {
  ExactMoments moments = moments_of({0x1p63});
  const auto double_until_full = [&] {
    for (int i = 0; i < 40; ++i) moments.merge(ExactMoments(moments));
  };
  EXPECT_THROW(double_until_full(), std::overflow_error);
}

// The property that threads, resumes and shards rest on.
RC_GTEST_PROP(ExactMoments, AreTheSameForEverySplitAndOrder, ()) {
  const auto draw = rc::gen::map(rc::gen::pair(rc::gen::inRange(1, 1 << 30), rc::gen::inRange(-120, 33)),
                                 [](const std::pair<int, int>& x) { return std::ldexp(x.first, x.second); });
  const auto draws = *rc::gen::container<std::vector<double>>(draw);
  const ExactMoments expected = moments_of(draws);

  std::vector<ExactMoments> parts(1 + *rc::gen::inRange<std::size_t>(0, 7));
  auto shuffled = draws;
  for (std::size_t i = shuffled.size(); i > 1; --i)
    std::swap(shuffled[i - 1], shuffled[*rc::gen::inRange<std::size_t>(0, i)]);
  for (double x : shuffled) parts[*rc::gen::inRange<std::size_t>(0, parts.size())].add(x);
  ExactMoments merged;
  for (const ExactMoments& part : parts) merged.merge(part);
  RC_ASSERT(merged == expected);
}

RC_GTEST_PROP(ExactMoments, AgreeWithIntegerArithmetic, ()) {
  const auto draws = *rc::gen::container<std::vector<std::uint16_t>>(rc::gen::arbitrary<std::uint16_t>());
  RC_PRE(draws.size() >= 2);
  const auto n = static_cast<std::int64_t>(draws.size());
  std::int64_t sum = 0;
  std::int64_t squares = 0;
  ExactMoments moments;
  for (std::int64_t x : draws) {
    sum += x;
    squares += x * x;
    moments.add(static_cast<double>(x));
  }
  RC_ASSERT(moments.mean() == static_cast<double>(sum) / static_cast<double>(n));
  RC_ASSERT(moments.variance() ==
            static_cast<double>(n * squares - sum * sum) / (static_cast<double>(n) * static_cast<double>(n - 1)));
}

bool are_those_of_each_alone(const std::vector<float>& floats) {
  ExactMoments one_by_one, together;
  for (float x : floats) one_by_one.add(static_cast<double>(x));
  together.add(std::span<const float>(floats));
  return together == one_by_one;
}

RC_GTEST_PROP(ExactMoments, OfManyFloatsAreThoseOfEachAlone, ()) {
  const int lowest = *rc::gen::inRange(-149, 40);
  const int highest = lowest + *rc::gen::element(1, 5, 20, 40 - lowest);
  const auto floats = *rc::gen::container<std::vector<float>>(
      rc::gen::map(rc::gen::pair(rc::gen::inRange(0, 1 << 24), rc::gen::inRange(lowest, std::min(highest, 40))),
                   [](const std::pair<int, int>& x) { return std::ldexp(static_cast<float>(x.first), x.second); }));
  RC_ASSERT(are_those_of_each_alone(floats));
}

TEST(ExactMoments, OfMoreFloatsThanAreAddedAtOnce) {
  EXPECT_TRUE(are_those_of_each_alone(std::vector<float>(200'000, std::nextafter(2.0F, 0.0F))));
}

// As large as they may be, beside the smallest, with all digits set.
TEST(ExactMoments, OfFloatsThatAreFarApart) {
  for (int apart = 20; apart <= 60; ++apart) {
    std::vector<float> floats(64, std::nextafter(std::ldexp(2.0F, apart), 0.0F));
    floats[17] = std::nextafter(1.0F, 2.0F);
    EXPECT_TRUE(are_those_of_each_alone(floats)) << apart;
    for (float& x : floats) x = std::ldexp(x, -73);  // the smallest is 2^-73 and 2^-96
    EXPECT_TRUE(are_those_of_each_alone(floats)) << apart;
  }
}

TEST(ExactMoments, OfFloatsAreUnchangedWhenOneIsRefused) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float bad : {-1.0F, 0x1p64F, nan}) {
    ExactMoments moments;
    std::vector<float> floats(200, 1.0F);
    floats.back() = bad;
    EXPECT_THROW(moments.add(std::span<const float>(floats)), std::domain_error);
    const std::vector<double> doubles{1, static_cast<double>(bad)};
    EXPECT_THROW(moments.add(std::span<const double>(doubles)), std::domain_error);
    EXPECT_EQ(moments, ExactMoments());
  }
}

}  // namespace
}  // namespace fairlight

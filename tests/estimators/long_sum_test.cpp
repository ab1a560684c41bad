#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/lights.h>

#include <fairlight/estimators/long_sum.h>

namespace fairlight {
namespace {

// 2^24 + 1 is not a float; ten numbers of 1e-7, added one by one, vanish beside 1.
TEST(LongSum, KeepsWhatAFloatRoundsOff) {
  LongSum<float> sum;
  sum.add(0x1p24f);
  sum.add(1);
  EXPECT_EQ(sum.high, 0x1p24f);
  EXPECT_EQ(sum.low, 1);
  LongSum<float> millionths;
  millionths.add(1);
  for (int i = 0; i < 10; ++i) millionths.add(0x1p-26f);
  EXPECT_EQ(static_cast<double>(millionths.high) + static_cast<double>(millionths.low), 1 + 10 * 0x1p-26);
}

TEST(LongSum, ComparesBothParts) {
  const LongSum<double> less{1, 0}, more{1, 0x1p-60}, most{2, -0x1p-60};
  EXPECT_TRUE(less <= less);
  EXPECT_TRUE(less <= more);
  EXPECT_FALSE(more <= less);
  EXPECT_TRUE(more <= most);
  EXPECT_FALSE(most <= more);
}

// An addition to the low part has a rounding error of at most u times that part, which is at most n
// u times the sum; u = 2^-24.
RC_GTEST_PROP(LongSum, IsExactToTheSquareOfWhatOneAdditionRounds, ()) {
  LongSum<float> sum;
  LongSum<Packet> packets;
  double expected = 0;
  const int n = *rc::gen::inRange(1, 1000);
  for (int i = 0; i < n; ++i) {
    const auto x = static_cast<float>(*testing::length());
    sum.add(x);
    packets.add(Packet(x));
    expected += static_cast<double>(x);
  }
  const double total = static_cast<double>(sum.high) + static_cast<double>(sum.low);
  RC_ASSERT(std::abs(total - expected) <= n * n * 0x1p-48 * expected);
  RC_ASSERT(testing::first_lane(packets.high) == static_cast<double>(sum.high));
  RC_ASSERT(testing::first_lane(packets.low) == static_cast<double>(sum.low));
}

}  // namespace
}  // namespace fairlight

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <fairlight/stats/exact_sums.h>

namespace fairlight {
namespace {

// Half has the lowest exponent: its last digit is 2^-24.
TEST(ExactSums, AreInUnitsOfTheLowestDrawsLastDigit) {
  const std::vector<float> draws{1, 2, 0, 0.5};
  const auto sums = ExactSums::of(draws);
  ASSERT_TRUE(sums);
  EXPECT_EQ(sums->count(), 4u);
  EXPECT_EQ(sums->unit(), -24);
  EXPECT_EQ(static_cast<double>(sums->sum()), std::ldexp(3.5, 24));
  EXPECT_EQ(static_cast<double>(sums->squares()), std::ldexp(5.25, 48));
}

TEST(ExactSums, HaveAllPlacesWhateverTheirNumber) {
  for (std::size_t n = 1; n <= ExactSums::most; ++n) {
    std::vector<float> draws(n);
    for (std::size_t i = 0; i < n; ++i) draws[i] = static_cast<float>(i + 1);
    const auto sums = ExactSums::of(draws);
    ASSERT_TRUE(sums) << n;
    const auto m = static_cast<double>(n);
    EXPECT_EQ(std::ldexp(static_cast<double>(sums->sum()), sums->unit()), m * (m + 1) / 2) << n;
    EXPECT_EQ(std::ldexp(static_cast<double>(sums->squares()), 2 * sums->unit()), m * (m + 1) * (2 * m + 1) / 6)
        << n;
  }
}

// Significands of 24 ones, of the lowest exponent and of the highest that doubles hold with it.
TEST(ExactSums, RoundNothingOfTheWidestThatTheyTake) {
  const std::int64_t ones = 0xFFFFFF;
  std::vector<float> draws(ExactSums::most, std::ldexp(static_cast<float>(ones), 23));
  draws[5] = static_cast<float>(ones);
  const auto sums = ExactSums::of(draws);
  ASSERT_TRUE(sums);
  EXPECT_EQ(sums->unit(), 0);
  EXPECT_EQ(sums->sum(), 63 * (ExactSums::Int128{ones} << 23) + ones);
  EXPECT_EQ(sums->squares(), 63 * (ExactSums::Int128{ones} * ones << 46) + ExactSums::Int128{ones} * ones);
}

TEST(ExactSums, LeaveAloneWhatTheyWouldRoundOrWhatIsNoDraw) {
  const auto taken = [](const std::vector<float>& draws) { return ExactSums::of(draws).has_value(); };
  EXPECT_TRUE(taken({1, 0x1p23F, 0}));
  EXPECT_FALSE(taken({1, 0x1p24F}));
  EXPECT_FALSE(taken(std::vector<float>(ExactSums::most + 1, 1.0F)));
  EXPECT_FALSE(taken({0, 0}));
  EXPECT_FALSE(taken({}));
  EXPECT_TRUE(taken({0x1p-73F}));
  EXPECT_FALSE(taken({0x1p-74F}));
  for (const float bad : {-1.0F, -0.0F, 0x1p64F, std::numeric_limits<float>::quiet_NaN()})
    EXPECT_FALSE(taken({1, bad}));
}

}  // namespace
}  // namespace fairlight

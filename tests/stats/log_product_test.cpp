#include <cmath>

#include <gtest/gtest.h>

#include <fairlight/stats/log_product.h>

namespace fairlight {
namespace {

LogProduct power(double factor, int n) {
  LogProduct product;
  for (int i = 0; i < n; ++i) product.multiply(factor);
  return product;
}

TEST(LogProduct, IsTheSumOfLogarithms) {
  EXPECT_EQ(LogProduct().log(), 0);
  EXPECT_DOUBLE_EQ(power(2, 10).log(), 10 * std::log(2));
  EXPECT_NEAR(power(1e90, 100).log(), 9000 * std::log(10), 1e-8);
  EXPECT_NEAR(power(1e-90, 100).log(), -9000 * std::log(10), 1e-8);
}

TEST(LogProduct, ComesBackFromWhereADoubleEnds) {
  LogProduct product = power(1e90, 100);
  for (int i = 0; i < 100; ++i) product.multiply(1e-90);
  EXPECT_NEAR(product.log(), 0, 1e-8);
}

TEST(LogProduct, ReachesWhatItIsAndNoMore) {
  EXPECT_TRUE(power(2, 10).reaches(1024));
  EXPECT_FALSE(power(2, 10).reaches(1024.5));
  EXPECT_TRUE(power(1e90, 3).reaches(1e269));
  EXPECT_FALSE(power(1e90, 3).reaches(1e271));
  EXPECT_FALSE(power(1e-60, 2).reaches(1.01));
}

}  // namespace
}  // namespace fairlight

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include <fairlight/stats/uniformity.h>

namespace fairlight {
namespace {

// Every p-value of a grid of 1000, bent by a power.
Uniformity of_grid(double power) {
  std::vector<double> p_values;
  for (int i = 0; i < 1000; ++i) p_values.push_back(std::pow((i + 0.5) / 1000, power));
  return uniformity(p_values, 0.01);
}

TEST(Uniformity, AcceptsAGridAndNoPowerOfIt) {
  EXPECT_TRUE(of_grid(1).uniform);
  EXPECT_FALSE(of_grid(1.2).uniform);
  EXPECT_FALSE(of_grid(0.8).uniform);
}

// Too many small p-values and as many large ones too few: Fisher's statistic sees the small end.
TEST(Uniformity, SeesAnExcessAtTheSmallEnd) { EXPECT_LT(of_grid(1.2).fisher_small, 1e-6); }

TEST(Uniformity, RefusesWhatIsNoPValue) {
  for (double wrong : {0.0, 1.0, -0.1, 1.1}) {
    std::vector<double> p_values{0.5, wrong};
    EXPECT_THROW(uniformity(p_values, 0.01), std::invalid_argument) << wrong;
  }
  std::vector<double> none;
  EXPECT_THROW(uniformity(none, 0.01), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

#include <array>
#include <limits>
#include <random>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <fairlight/stats/googletest.h>

namespace fairlight {
namespace {

double uniform(Generator& g) { return std::uniform_real_distribution<>()(g); }
Eigen::Vector3d rgb(Generator& g) { return {uniform(g), 2 * uniform(g), 3 * uniform(g)}; }

bool says(const Expectation& found, const std::string& part) {
  return found.message.find(part) != std::string::npos;
}

TEST(Channels, OfArraysAndEigenVectorsAreTestedTogether) {
  const Eigen::Array3d means(0.5, 1, 1.5);
  EXPECT_UNBIASED(rgb, bounded(means, 0, 3), 0.05);
  EXPECT_UNBIASED(rgb, (std::array{bounded(0.5, 0, 1), bounded(1, 0, 2), bounded(1.5, 0, 3)}), 0.05);
  EXPECT_UNBIASED(rgb, means, 0.05);
  const auto pair = [](Generator& g) { return std::vector<float>{static_cast<float>(uniform(g)), 0.5f}; };
  EXPECT_UNBIASED(pair, bounded(std::vector{0.5, 0.5}, 0, 1), 0.05);
  EXPECT_AT_MOST(rgb, bounded(means, 0, 3), 0.05);
  EXPECT_AGREE(rgb, rgb, 0.05);
  EXPECT_AGREE(in_range(rgb, 0, 3), in_range(rgb, 0, 3), 0.05);
}

TEST(Channels, ThatFailAreNamed) {
  const Eigen::Array3d wrong(0.5, 1.2, 1.5);
  const Expectation exact = expect_unbiased(googletest_site(), rgb, bounded(wrong, 0, 3), 0.05);
  EXPECT_TRUE(exact.message.starts_with("biased: channel 1 of 0 to 2: the mean is 1.2")) << exact.message;
  const Expectation plain = expect_unbiased(googletest_site(), rgb, wrong, 0.05);
  EXPECT_TRUE(plain.message.starts_with("undecided: channel 1 of 0 to 2: the mean is 1.2")) << plain.message;
  const auto grey = [](Generator& g) { return Eigen::Vector3d(uniform(g), 2 * uniform(g), 2 * uniform(g)); };
  const Expectation agree = expect_agree(googletest_site(), in_range(grey, 0, 3), in_range(rgb, 0, 3), 0.05);
  EXPECT_TRUE(agree.message.starts_with("biased: channel 2 of 0 to 2: the two means agree")) << agree.message;
}

TEST(Channels, AreNamedWhereADrawCannotBe) {
  const auto broken = [](Generator& g) {
    return Eigen::Vector2d(uniform(g), uniform(g) < 0.01 ? std::numeric_limits<double>::quiet_NaN() : 0.5);
  };
  const Expectation found = expect_unbiased(googletest_site(), broken, bounded(std::array{0.5, 0.5}, 0, 1), 0.01);
  EXPECT_TRUE(says(found, "is nan (not a finite number), in channel 1")) << found.message;
}

TEST(Channels, AreRefusedWhereTheirNumberDiffersFromThatOfTheReferences) {
  EXPECT_THROW(expect_unbiased(googletest_site(), rgb, 0.5, 0.05), std::invalid_argument);
  EXPECT_THROW(expect_unbiased(googletest_site(), uniform, std::array{0.5, 0.5}, 0.05), std::invalid_argument);
  EXPECT_THROW(expect_unbiased(googletest_site(), rgb, std::vector<double>{}, 0.05), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight

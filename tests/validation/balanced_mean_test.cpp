#include <gtest/gtest.h>

#include <fairlight/validation/checks/balanced_mean.h>
#include <fairlight/validation/checks/side_sums.h>

namespace fairlight {
namespace {

// Four tiles of a pixel each, the last of which is 30 times as bright: nearest to 2^5.
struct Bright : ::testing::Test {
  const PixelWindow region{0, 0, 4, 1};
  const PictureCells cells{region, 1};

  SideOfCells side(const std::vector<float>& brightness, const PixelNoise& noise = {}) const {
    std::vector<PixelBlock> pictures;
    for (float factor : brightness) {
      PixelBlock block;
      for (auto& plane : block.colour) plane = {factor, factor, factor, 30 * factor};
      for (auto& plane : block.error) plane = {1, 1, 1, 16};
      block.samples = {5, 5, 5, 5};
      pictures.push_back(block);
    }
    SideSums sums(cells, pictures.size(), noise);
    sums.add(region, pictures);
    return std::move(sums).finish();
  }
};

constexpr double whole_weight = 3 + 1. / 32, whole_sum = 3 + 30. / 32;

TEST_F(Bright, TilesWeighLess) {
  const SideOfCells pictures = side({1, 2, 3});
  const EstimatedMean mean = BalancedMean(cells, pictures, pictures).of(pictures, 0);
  EXPECT_NEAR(mean.mean, 2 * whole_sum / whole_weight, 1e-12);
  EXPECT_NEAR(mean.squared_error, whole_sum * whole_sum / (whole_weight * whole_weight) / 3, 1e-12);
  EXPECT_EQ(mean.degrees, 2);
}

TEST_F(Bright, TilesOfOnePictureAreIndependent) {
  const SideOfCells picture = side({1}, {.error_layer = ErrorLayer::standard_error});
  const EstimatedMean mean = BalancedMean(cells, picture, picture).of(picture, 0);
  EXPECT_NEAR(mean.squared_error, (3 + 16 * 16. / (32 * 32)) / (whole_weight * whole_weight), 1e-12);
}

}  // namespace
}  // namespace fairlight

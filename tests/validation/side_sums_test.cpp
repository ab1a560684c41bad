#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <fairlight/validation/checks/side_sums.h>

namespace fairlight {
namespace {

const PixelWindow region{0, 0, 2, 1};

// A picture of two pixels, equal in all channels.
PixelBlock pixels(float left, float right) {
  PixelBlock block;
  for (auto& plane : block.colour) plane = {left, right};
  return block;
}

PixelBlock with_errors(PixelBlock block, float left, float right, float samples) {
  for (auto& plane : block.error) plane = {left, right};
  block.samples = {samples, samples};
  return block;
}

SideOfCells side(const PictureCells& cells, const std::vector<PixelBlock>& pictures, const PixelNoise& noise = {}) {
  SideSums sums(cells, pictures.size(), noise);
  sums.add(region, pictures);
  return std::move(sums).finish();
}

// The means of the pictures are 2, 3 and 7: their mean is 4 and its squared error (4 + 1 + 9) / 6.
TEST(SideSums, TakeTheVarianceBetweenPictures) {
  const PictureCells cells(region, 1);
  const SideOfCells three = side(cells, {pixels(1, 3), pixels(2, 4), pixels(6, 8)});
  const EstimatedMean& whole = three.estimates[cells.whole(1)];
  EXPECT_DOUBLE_EQ(whole.mean, 4);
  EXPECT_DOUBLE_EQ(whole.squared_error, 14. / 6);
  EXPECT_EQ(whole.degrees, 2);
  EXPECT_DOUBLE_EQ(three.estimates[cells.tile(1, 0)].mean, 5);
  EXPECT_DOUBLE_EQ(three.means[2][cells.tile(0, 2)], 6);
}

TEST(SideSums, TakeTheVarianceFromErrorLayers) {
  const PictureCells cells(region, 1);
  const PixelBlock picture = with_errors(pixels(4, 8), 3, 1, 11);
  const PixelNoise noise{.error_layer = ErrorLayer::standard_error};
  const EstimatedMean one = side(cells, {picture}, noise).estimates[cells.whole(0)];
  EXPECT_DOUBLE_EQ(one.squared_error, (9. + 1) / 4);
  EXPECT_DOUBLE_EQ(one.degrees, 100 / (81. / 10 + 1. / 10));
  const EstimatedMean two = side(cells, {picture, picture}, noise).estimates[cells.whole(0)];
  EXPECT_DOUBLE_EQ(two.squared_error, one.squared_error / 2);
  EXPECT_DOUBLE_EQ(two.degrees, 2 * one.degrees);
}

// Of 11 samples: the variance of a sample is 44, its second moment 4^2 + 40 = 56 before the
// correction for the mean.
TEST(SideSums, ReadVariancesAndSecondMomentsOfSamples) {
  const PictureCells cells(region, 1);
  const auto error = [&](ErrorLayer layer, float left) {
    return side(cells, {with_errors(pixels(4, 0), left, 0, 11)}, {.error_layer = layer})
        .estimates[cells.tile(0, 0)]
        .squared_error;
  };
  EXPECT_DOUBLE_EQ(error(ErrorLayer::variance, 44), 4);
  EXPECT_DOUBLE_EQ(error(ErrorLayer::second_moment, 56), 4);
  EXPECT_EQ(error(ErrorLayer::second_moment, std::nextafter(16.f, 0.f)), 0) << "rounding";
  EXPECT_THROW(error(ErrorLayer::second_moment, 15), std::domain_error);
}

TEST(SideSums, CountSetsOfSamplesAsDraws) {
  const PictureCells cells(region, 1);
  const PixelNoise noise{.error_layer = ErrorLayer::standard_error, .samples_per_draw = 4};
  EXPECT_DOUBLE_EQ(side(cells, {with_errors(pixels(1, 1), 1, 1, 12)}, noise).estimates[cells.tile(0, 0)].degrees,
                   2);
}

// A filter of radius 1 makes a pixel depend on the 3 x 3 about it.
TEST(SideSums, BoundTheVarianceUnderAWideFilter) {
  const PictureCells cells(region, 1);
  const auto error = [&](double radius) {
    return side(cells, {with_errors(pixels(4, 8), 3, 1, 11)},
                {.error_layer = ErrorLayer::standard_error, .filter_radius = radius})
        .estimates[cells.whole(0)]
        .squared_error;
  };
  EXPECT_DOUBLE_EQ(error(1), 9 * error(0.5));
  EXPECT_DOUBLE_EQ(error(1.5), 25 * error(0.5));
}

TEST(SideSums, RefuseAPixelWithoutAUsableError) {
  const PictureCells cells(region, 1);
  const PixelNoise noise{.error_layer = ErrorLayer::standard_error};
  const float infinite = std::numeric_limits<float>::infinity();
  EXPECT_THROW(side(cells, {with_errors(pixels(1, 1), 1, infinite, 1)}, noise), std::domain_error);
  EXPECT_THROW(side(cells, {with_errors(pixels(1, 1), 1, 1, 1)}, noise), std::domain_error);
  EXPECT_THROW(side(cells, {with_errors(pixels(1, 1), NAN, 1, 2)}, noise), std::domain_error);
}

TEST(SideSums, CountRoundingOnlyWhereNoiseDoesNotHideIt) {
  const PictureCells cells(region, 1);
  const SideOfCells half = side(cells, {pixels(1, 1), pixels(1, 2)}, {.half = true});
  EXPECT_DOUBLE_EQ(half.rounding[cells.tile(0, 0)], 0x1p-11);
  EXPECT_EQ(half.rounding[cells.tile(1, 0)], 0);
  EXPECT_DOUBLE_EQ(half.rounding[cells.whole(0)], 0x1p-12);
}

// Equal pixels of relative deviation s have the skewness 3 s, as a lognormal law; a cell whose
// noise is in one of them more.
TEST(SideSums, EstimateTheSkewnessOfALognormalLaw) {
  const PictureCells cells(region, 1);
  const PixelNoise noise{.error_layer = ErrorLayer::standard_error};
  const auto skewness = [&](float left, float right) {
    return side(cells, {with_errors(pixels(1, 1), left, right, 100)}, noise).estimates[cells.whole(0)].skewness;
  };
  EXPECT_NEAR(skewness(0.1f, 0.1f), 3 * 0.1 / std::sqrt(2), 1e-7);
  EXPECT_NEAR(skewness(0.1f, 0), 3 * 0.1, 1e-7);
}

}  // namespace
}  // namespace fairlight

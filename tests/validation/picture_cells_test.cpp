#include <stdexcept>

#include <gtest/gtest.h>

#include <fairlight/validation/checks/picture_cells.h>

namespace fairlight {
namespace {

TEST(PictureCells, CoverTheRegionWithTilesOfNearlyEqualSize) {
  const PictureCells cells({10, 20, 33, 30}, 4);  // 23 x 10 pixels
  EXPECT_EQ(cells.columns(), 6);
  EXPECT_EQ(cells.rows(), 3);
  double pixels = 0;
  for (std::size_t t = 0; t < cells.tiles(); ++t) {
    const PixelWindow window = cells.tile_window(t);
    EXPECT_GE(window.width(), 3);
    EXPECT_LE(window.width(), 4);
    pixels += cells.pixels(cells.tile(t, 2));
    for (int y = window.y0; y < window.y1; ++y) {
      for (int x = window.x0; x < window.x1; ++x) EXPECT_EQ(cells.tile_at(x - 10, y - 20), t);
    }
  }
  EXPECT_EQ(pixels, 230);
  EXPECT_EQ(cells.pixels(cells.whole(1)), 230);
}

TEST(PictureCells, HaveABorderOfEightPixelsOrAQuarter) {
  const PictureCells large({0, 0, 100, 50}, 0);
  EXPECT_TRUE(large.in_border(7, 20));
  EXPECT_FALSE(large.in_border(8, 20));
  EXPECT_TRUE(large.in_border(50, 42));
  EXPECT_FALSE(large.in_border(50, 41));
  EXPECT_EQ(large.pixels(large.border(0)), 5000 - 84 * 34);
  const PictureCells small({0, 0, 8, 8}, 0);
  EXPECT_EQ(small.pixels(small.border(0)), 64 - 16);
  const PictureCells tiny({0, 0, 3, 3}, 0);
  EXPECT_EQ(tiny.pixels(tiny.border(0)), 0);
}

TEST(PictureCells, HaveEightTilesAlongTheLongerSideUnlessToldOtherwise) {
  const PictureCells cells({0, 0, 128, 64}, 0);
  EXPECT_EQ(cells.columns(), 8);
  EXPECT_EQ(cells.rows(), 4);
  EXPECT_EQ(PictureCells({0, 0, 5, 5}, 100).tiles(), 1u);
}

TEST(PictureCells, RefuseNoPixelsAndTooManyTiles) {
  EXPECT_THROW(PictureCells({0, 0, 0, 5}, 0), std::invalid_argument);
  EXPECT_THROW(PictureCells({0, 0, 1000, 1000}, 1), std::invalid_argument);
  EXPECT_NO_THROW(PictureCells({0, 0, 16384, 16384}, 64));
}

}  // namespace
}  // namespace fairlight

#include <cmath>

#include <gtest/gtest.h>
#include <support/temporary_folder.h>

#include <fairlight/validation/report/charts.h>

namespace fairlight {
namespace {

constexpr Colour black{0, 0, 0};
constexpr Colour white{255, 255, 255};

TEST(Canvas, IsWhiteUntilItIsDrawnOnAndLosesWhatLiesOffIt) {
  Canvas canvas(20, 10);
  EXPECT_EQ(canvas.at(3, 4), white);
  canvas.rectangle(-5, -5, 4, 5, black);
  EXPECT_EQ(canvas.at(3, 4), black);
  EXPECT_EQ(canvas.at(4, 4), white);
  canvas.line(0, 9, 100, 9, black);
  EXPECT_EQ(canvas.at(19, 9), black);
}

TEST(Canvas, WritesLettersOfTwoPixelDots) {
  Canvas canvas(30, 20);
  canvas.text(0, 0, "I");  // columns of dots: none, ends, full, ends, none
  EXPECT_EQ(canvas.at(0, 0), white);
  EXPECT_EQ(canvas.at(2, 0), black);
  EXPECT_EQ(canvas.at(2, 4), white);
  EXPECT_EQ(canvas.at(4, 7), black);
  EXPECT_EQ(canvas.at(5, 13), black);
  EXPECT_EQ(canvas.at(5, 14), white);
}

TEST(Canvas, IsWrittenAsAPng) {
  const testing::TemporaryFolder folder;
  Canvas(3, 2).write(folder / "a.png");
  EXPECT_TRUE(testing::read_file(folder / "a.png").starts_with("\x89PNG"));
  EXPECT_THROW(Canvas(3, 2).write(folder / "none/a.png"), std::runtime_error);
}

// 100 draws in 2 x 2 cells that expect 25 each: 40 are 15 / sqrt(100/4 x 3/4) = 3.46 deviations too many.
const Evidence::Cells cells{2, 2, {0.25, 0.25, 0.25, 0.25}, {40, 20, 20, 20}, 100};

TEST(CellResidue, IsInStandardDeviationsWithAPValueOfBothTails) {
  const CellResidue first = cell_residue(cells, 0);
  EXPECT_EQ(first.expected, 25);
  EXPECT_DOUBLE_EQ(first.deviations, 15 / std::sqrt(18.75));
  EXPECT_LT(first.p, 0.01);
  EXPECT_GT(first.p, 1e-4);
  EXPECT_LT(cell_residue(cells, 1).deviations, 0);
  EXPECT_GT(cell_residue(cells, 1).p, 0.1);
  EXPECT_EQ(cell_residue({1, 2, {0, 1}, {0, 5}, 5}, 0).p, 1) << "a cell that cannot be hit and is not";
}

TEST(PMap, IsRedWhereThereAreTooManyAndBlueWhereTooFew) {
  const Canvas map = p_map_chart("a", cells);
  const Colour many = map.at(40, 140);
  const Colour few = map.at(80, 140);
  EXPECT_GT(many[0], many[2]);
  EXPECT_GT(few[2], few[0]);
}

TEST(Charts, AreDrawnForLawsOfEveryShape) {
  Evidence::Cells line{300, 1, std::vector<double>(300, 1. / 300), std::vector<std::uint64_t>(300, 100), 30000};
  EXPECT_GT(histogram_chart("line", line).width(), 0);
  EXPECT_GT(histogram_chart("square", cells).width(), histogram_chart("line", line).width());
  EXPECT_GT(p_map_chart("line", line).height(), 0);
  EXPECT_GT(p_map_chart("many", {1 << 15, 1, std::vector<double>(1 << 15, 1. / (1 << 15)),
                                 std::vector<std::uint64_t>(1 << 15, 1), 1 << 15})
                .height(),
            0);
}

// 2 x 2 tiles of 320 pixels each.
TEST(TileMap, IsRedWhereATileIsTooBrightAndBlueWhereTooDark) {
  const Canvas map = tile_map_chart("a", {2, {2, -1, 0, -5}});
  const Colour bright = map.at(180, 240), dark = map.at(500, 240), right = map.at(180, 560),
               darkest = map.at(500, 560);
  EXPECT_GT(bright[0], bright[2]);
  EXPECT_GT(dark[2], dark[0]);
  EXPECT_EQ(right, (Colour{255, 255, 255}));
  EXPECT_LT(darkest[0], dark[0]);
}

TEST(WealthChart, ShowsTheProcessThatRefutes) {
  BettingTest test({.mean = 0.5, .margin = 0.01, .lower = 0, .upper = 1}, 1e-6, 0.01);
  Evidence::Course course(test);
  while (test.verdict() == Verdict::undecided) {
    test.add(std::vector<double>(test.block_size(), 1.0));
    course.add(test);
  }
  const Canvas chart = wealth_chart("bright", course);
  int reds = 0;
  for (int x = 200; x < 1000; ++x) {
    for (int y = 110; y < 570; ++y) reds += chart.at(x, y) == Colour{200, 30, 30} ? 1 : 0;
  }
  EXPECT_GT(reds, 500);
  EXPECT_GT(wealth_chart("not begun", Evidence::Course(test)).width(), 0);
}

}  // namespace
}  // namespace fairlight

#include <limits>

#include <gtest/gtest.h>
#include <support/temporary_folder.h>

#include <fairlight/validation/report/compare_report.h>

namespace fairlight {
namespace {

using testing::read_file;
using testing::TemporaryFolder;

// Two tiles of 2 x 2 pixels; in the second, A is 3 % brighter in green.
struct Compared {
  ComparedCells cells{PictureCells({4, 0, 8, 2}, 2), {}, {}, {"R", "G", "B"}};
  Comparison comparison;

  Compared() {
    cells.a.means.resize(3);
    cells.b.means.resize(5);
    comparison.tiles.resize(6);
    for (CellComparison& tile : comparison.tiles) tile.margin = 0.02;
    comparison.worst = 4;
    comparison.tiles[4] = {Likeness::different, 0.03, {0.02, 0.04}, 0.02, 1e-9, 0};
    comparison.verdict = Likeness::different;
    comparison.renders_for_margin = 2.5;
  }
};

TEST(CompareReport, MapsTheTilesToPixels) {
  const TemporaryFolder folder;
  const Compared compared;
  write_heat_map(folder / "map.exr", compared.cells, compared.comparison);
  PictureFile map(folder / "map.exr");
  EXPECT_EQ(map.data_window(), (PixelWindow{0, 0, 4, 2}));
  const std::vector<float> row{0, 0, 0.03f, 0.03f};
  EXPECT_EQ(map.read({0, 1, 4, 2}).colour[1], row);
  EXPECT_EQ(PictureFile(folder / "map.exr", "high").read({3, 0, 4, 1}).colour[1], std::vector<float>{0.04f});
  EXPECT_EQ(PictureFile(folder / "map.exr", "p").read({3, 0, 4, 1}).colour[1], std::vector<float>{1e-9f});
}

TEST(CompareReport, WritesAPng) {
  const TemporaryFolder folder;
  const Compared compared;
  write_heat_map_png(folder / "map.png", compared.cells, compared.comparison);
  EXPECT_EQ(read_file(folder / "map.png").substr(1, 3), "PNG");
}

TEST(CompareReport, IsReadableByAScript) {
  Compared compared;
  compared.comparison.whole[2].interval = {-std::numeric_limits<double>::infinity(), 0.1};
  const nlohmann::json json = comparison_json(compared.cells, compared.comparison, {.margin = 0.002});
  EXPECT_EQ(json["verdict"], "different");
  EXPECT_EQ(json["guarantee"], "asymptotic");
  EXPECT_EQ(json["margin"], 0.002);
  EXPECT_EQ(json["renders"], nlohmann::json({3, 5}));
  EXPECT_EQ(json["renders_for_margin"], 13);  // 2.5 times 5, rounded up
  EXPECT_EQ(json["channels"][2]["interval"], nlohmann::json({nullptr, 0.1}));
  EXPECT_EQ(json["tiles"],
            nlohmann::json({{"columns", 2}, {"rows", 1}, {"same", 0}, {"different", 1}, {"undecided", 5}}));
  EXPECT_EQ(json["worst_tile"]["name"], "G");
  EXPECT_EQ(json["worst_tile"]["x0"], 6);
  EXPECT_EQ(json["worst_tile"]["difference"], 0.03);
}

TEST(CompareReport, SaysWhereNoNumberOfRendersIsEnough) {
  Compared compared;
  compared.comparison.renders_for_margin = std::numeric_limits<double>::infinity();
  EXPECT_EQ(renders_for_margin(compared.cells, compared.comparison), 0);
}

}  // namespace
}  // namespace fairlight

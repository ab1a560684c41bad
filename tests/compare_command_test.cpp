#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <support/program.h>

namespace fairlight {
namespace {

using testing::expect_bad_input;
using testing::fairlight;
using testing::read_file;
using testing::Result;
using testing::TemporaryFolder;

// Renders NAME1.exr to NAME4.exr, 24 x 18 pixels of 256 samples.
void render_four(const TemporaryFolder& folder, const std::string& name, const std::string& options) {
  for (const char* number : {"1", "2", "3", "4"}) {
    const Result run =
        fairlight("render cornell-simple --width 24 --height 18 --spp 256 --light-sampling cone -o " + name +
                      number + ".exr " + options,
                  folder);
    ASSERT_EQ(run.status, 0) << run.error;
  }
}

const std::string fours = "compare a1.exr a2.exr a3.exr a4.exr --with b1.exr b2.exr b3.exr b4.exr ";

// The luminaire, at the top, is left out: its edge is by far the noisiest part.
TEST(Compare, ShowsThatTwoStrategiesAreTheSame) {
  const TemporaryFolder folder;
  render_four(folder, "a", "--direct light");
  render_four(folder, "b", "--direct mis");
  const std::string margins = "--crop 0,8,24,18 --margin 0.1 --tile-margin 0.4 --alpha 1e-9 ";
  const Result run = fairlight(fours + margins + "--json c.json --heatmap map.exr --png map.png", folder);
  EXPECT_EQ(run.status, 0) << run.out << run.error;
  EXPECT_TRUE(run.out.starts_with("same: ")) << run.out;
  const auto json = nlohmann::json::parse(read_file(folder / "c.json"));
  EXPECT_EQ(json["verdict"], "same");
  EXPECT_EQ(json["renders"], nlohmann::json({4, 4}));
  EXPECT_EQ(json["channels"].size(), 3u);
  EXPECT_LT(json["channels"][0]["interval"][1], 0.1);
  EXPECT_EQ(json["tiles"]["different"], 0);
  EXPECT_EQ(read_file(folder / "map.png").substr(1, 3), "PNG");
  EXPECT_EQ(fairlight("compare a1.exr --with b1.exr --crop 0,8,24,18 --margin 0.2 --tile-margin 0.45 --alpha 1e-9",
                      folder)
                .status,
            0)
      << "single pictures have error layers";
}

TEST(Compare, ShowsThatLongerPathsMakeADifference) {
  const TemporaryFolder folder;
  render_four(folder, "a", "--max-depth 2");
  render_four(folder, "b", "");
  const Result run = fairlight(fours + "--json c.json", folder);
  EXPECT_EQ(run.status, 1) << run.out << run.error;
  EXPECT_TRUE(run.out.starts_with("different: ")) << run.out;
  EXPECT_NE(run.out.find("darker"), std::string::npos) << run.out;
  const auto json = nlohmann::json::parse(read_file(folder / "c.json"));
  EXPECT_LT(json["worst_tile"]["interval"][1], 0);
}

TEST(Compare, IsUndecidedWhereThePicturesShowNeither) {
  const TemporaryFolder folder;
  render_four(folder, "a", "");
  render_four(folder, "b", "");
  const Result run = fairlight(fours + "--margin 1e-6 --alpha 1e-9", folder);
  EXPECT_EQ(run.status, 3) << run.out << run.error;
  EXPECT_NE(run.out.find("such renders a side"), std::string::npos) << run.out;
  EXPECT_NE(fairlight(fours + "--margin 0.2 --alpha 1e-9", folder).status, 2)
      << "the margin of tiles stays below 0.5";
}

TEST(Compare, RefusesRendersWithCommonSamples) {
  const TemporaryFolder folder;
  render_four(folder, "a", "--seed 5");
  const Result run = fairlight("compare a1.exr --with a2.exr", folder);
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.error.find("\"a2.exr\" has the seed and samples of another file"), std::string::npos) << run.error;
}

TEST(Compare, OverwritesNoInput) {
  const TemporaryFolder folder;
  render_four(folder, "a", "");
  const std::string before = read_file(folder / "a1.exr");
  const Result run = fairlight("compare a1.exr a2.exr --with a3.exr a4.exr --heatmap ./a1.exr", folder);
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.error.find("same file"), std::string::npos) << run.error;
  EXPECT_EQ(read_file(folder / "a1.exr"), before);
}

TEST(Compare, RefusesBadInputInOneSentence) {
  expect_bad_input("compare", "pictures");
  expect_bad_input("compare a.exr", "--with");
  expect_bad_input("compare a.exr --with", "--with");
  expect_bad_input("compare a.exr --with b.exr", "a.exr");
  expect_bad_input("compare a.exr --with b.exr --margin 0", "--margin");
  expect_bad_input("compare a.exr --with b.exr --margin 0.5", "--margin");
  expect_bad_input("compare a.exr --with b.exr --alpha 2", "--alpha");
  expect_bad_input("compare a.exr --with b.exr --tile 0", "--tile");
  expect_bad_input("compare a.exr --with b.exr --crop 1,2,3", "no region");
  expect_bad_input("compare a.exr --with b.exr --crop 4,2,3,5", "no region");
  expect_bad_input("compare a.exr --with b.exr --scale -2", "neither a positive number nor fit");
  expect_bad_input("compare a.exr --with b.exr --scale nan", "neither a positive number nor fit");
  expect_bad_input("compare a.exr --with b.exr --json missing/a.json", "missing/a.json");
  expect_bad_input("compare a.exr --with b.exr --json c --png ./c", "same file");
}

}  // namespace
}  // namespace fairlight

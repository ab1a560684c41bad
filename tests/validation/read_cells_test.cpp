#include <functional>
#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/temporary_folder.h>

#include <fairlight/render/raster.h>
#include <fairlight/validation/checks/read_cells.h>

namespace fairlight {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryFolder;

// Writes a picture of 6 x 5 pixels, each 10 + `brightness` + its number / 100, changed by `change`.
std::string picture(
    const TemporaryFolder& folder, const std::string& name, float brightness,
    const std::function<void(std::vector<Plane>&)>& change = [](auto&) {}) {
  std::vector<Plane> planes;
  for (const char* channel : {"R", "G", "B"}) {
    planes.push_back({channel, {}});
    for (int i = 0; i < 30; ++i) planes.back().values.push_back(10 + brightness + static_cast<float>(i) / 100);
  }
  change(planes);
  write_exr(folder / name, 6, 5, planes);
  return folder / name;
}

std::string problem(const std::vector<std::string>& a, const std::vector<std::string>& b,
                    const CellOptions& options = {}) {
  try {
    read_cells(a, b, options);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

struct ReadCells : ::testing::Test {
  TemporaryFolder folder;
  std::vector<std::string> a{picture(folder, "a1.exr", 1), picture(folder, "a2.exr", 2)},
      b{picture(folder, "b1.exr", 3), picture(folder, "b2.exr", 4)};
};

TEST_F(ReadCells, AddsUpTheCellsOfBothSides) {
  const ComparedCells compared = read_cells(a, b, {.tile = 3});
  const PictureCells& cells = compared.cells;
  EXPECT_EQ(cells.tiles(), 4u);
  EXPECT_NEAR(compared.a.estimates[cells.whole(2)].mean, 11.5 + 0.145, 1e-6);
  EXPECT_NEAR(compared.b.estimates[cells.whole(2)].mean, 13.5 + 0.145, 1e-6);
  EXPECT_EQ(compared.channels[0], "R");
  EXPECT_FALSE(compared.a.from_error_layer);
}

TEST_F(ReadCells, ReadsOnlyTheCrop) {
  const ComparedCells compared = read_cells(a, b, {.crop = PixelWindow{2, 1, 4, 2}, .tile = 1});
  EXPECT_NEAR(compared.a.estimates[compared.cells.tile(1, 0)].mean, 11.5 + 0.09, 1e-6);
  EXPECT_THAT(problem(a, b, {.crop = PixelWindow{2, 1, 7, 2}}), HasSubstr("--crop 2,1,7,2 is not inside"));
}

TEST_F(ReadCells, CountsAndNamesWhatIsNoNumber) {
  a.push_back(picture(folder, "bad.exr", 5, [](auto& planes) {
    planes[1].values[8] = std::numeric_limits<float>::quiet_NaN();
    planes[2].values[3] = std::numeric_limits<float>::infinity();
    planes[2].values[29] = -std::numeric_limits<float>::infinity();
  }));
  EXPECT_THAT(problem(a, b),
              HasSubstr("bad.exr\" holds 1 NaN and 2 infinite values, the first in G of pixel (2, 1)"));
  EXPECT_EQ(problem(a, b, {.crop = PixelWindow{0, 2, 5, 5}}), "") << "none of them is in the crop";
}

TEST_F(ReadCells, RefusesPicturesThatDependOnEachOther) {
  EXPECT_THAT(problem({a[0], a[0]}, b), HasSubstr("a1.exr\" is given twice"));
  EXPECT_THAT(problem(a, {b[0], a[1]}), HasSubstr("a2.exr\" is given twice"));
  std::filesystem::create_hard_link(a[0], folder / "link.exr");
  EXPECT_THAT(problem(a, {b[0], folder / "link.exr"}), HasSubstr("link.exr\" is given twice"));
  std::filesystem::copy_file(a[0], folder / "copy.exr");
  EXPECT_THAT(problem(a, {b[0], folder / "copy.exr"}), HasSubstr("hold the same pixels"));
}

TEST_F(ReadCells, RefusesPicturesThatAreNotAlike) {
  write_exr(folder / "narrow.exr", 5, 5,
            {{"R", std::vector<float>(25)}, {"G", std::vector<float>(25)}, {"B", std::vector<float>(25)}});
  EXPECT_THAT(
      problem(a, {b[0], folder / "narrow.exr"}),
      HasSubstr("a1.exr\" and \"" + folder / "narrow.exr" + "\" have different pixels, 0,0,6,5 and 0,0,5,5"));
}

TEST_F(ReadCells, AsksForSeveralPicturesOrErrorLayers) {
  EXPECT_THAT(problem({a[0]}, b), HasSubstr("a1.exr\" is alone on its side and has no error layer"));
  const auto with_variance = [](std::vector<Plane>& planes) {
    for (const char* name : {"Variance.R", "Variance.G", "Variance.B"})
      planes.push_back({name, std::vector<float>(30, 0.5f)});
  };
  const std::string variance = picture(folder, "variance.exr", 6, with_variance);
  EXPECT_THAT(problem({variance}, b), HasSubstr("by --samples"));
  EXPECT_EQ(problem({variance}, b, {.samples = 16}), "");
  const ComparedCells compared = read_cells({variance}, b, {.samples = 16});
  EXPECT_TRUE(compared.a.from_error_layer);
  EXPECT_NEAR(compared.a.estimates[0].squared_error, 0.5 / 16 / 30, 1e-12);
  EXPECT_FALSE(read_cells({variance, a[0]}, b, {}).a.from_error_layer) << "two pictures have a spread";
}

// Mitsuba's moment integrator has errors of X, Y, Z alone, so the other side is read as X, Y, Z
// too.
TEST_F(ReadCells, ComparesTheSameChannelsOnBothSides) {
  const auto moments = [&](const std::string& name, float brightness) {
    return picture(folder, name, brightness, [](std::vector<Plane>& planes) {
      for (const char* channel : {"X", "Y", "Z"}) {
        planes.push_back({std::string("path.") + channel, std::vector<float>(30, 3)});
        planes.push_back({std::string("m2_path.") + channel, std::vector<float>(30, 13)});
      }
      planes[3].values[0] = planes.front().values[0] / 8;  // so that no two pictures are equal
    });
  };
  const std::string one = moments("m5.exr", 5), two = moments("m6.exr", 6), three = moments("m7.exr", 7);
  const ComparedCells compared = read_cells({one}, {two, three}, {.samples = 9});
  EXPECT_EQ(compared.channels[0], "X");
  EXPECT_NEAR(compared.a.estimates[1].squared_error, (13. - 9) / 8 / 30, 1e-9);
  EXPECT_EQ(read_cells({one, two}, {three, a[0]}, {}).channels[0], "R");
  EXPECT_THAT(problem({one}, b, {.samples = 9}), HasSubstr("different channels, XYZ and RGB"));
}

}  // namespace
}  // namespace fairlight

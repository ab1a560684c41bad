#include <stdexcept>

#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIntAttribute.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfTiledOutputFile.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/small_picture.h>
#include <support/temporary_folder.h>

#include <fairlight/render/picture.h>
#include <fairlight/render/picture_file.h>

namespace fairlight {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::TemporaryFolder;

// Pixel (x, y) of the c-th channel holds 100 c + 10 y + x; the picture is 4 x 3.
constexpr int width = 4, height = 3;

struct Values {
  std::vector<std::string> names;
  std::vector<std::vector<float>> planes;

  explicit Values(const std::vector<std::string>& channels) : names(channels) {
    for (std::size_t c = 0; c < names.size(); ++c) {
      planes.emplace_back();
      for (int i = 0; i < width * height; ++i)
        planes.back().push_back(static_cast<float>(100 * static_cast<int>(c) + 10 * (i / width) + i % width));
    }
  }

  Imf::FrameBuffer buffer(const Imath::Box2i& window) {
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < names.size(); ++c)
      frame.insert(names[c], Imf::Slice::Make(Imf::FLOAT, planes[c].data(), window));
    return frame;
  }
};

Imf::Header header_of(const std::vector<std::string>& channels, Imf::PixelType type = Imf::FLOAT) {
  Imf::Header header(width, height);
  for (const std::string& name : channels) header.channels().insert(name, Imf::Channel(type));
  return header;
}

void write(const std::string& path, const Imf::Header& header, const std::vector<std::string>& channels) {
  Values values(channels);
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(values.buffer(header.dataWindow()));
  file.writePixels(height);
}

void write(const std::string& path, const std::vector<std::string>& channels) {
  write(path, header_of(channels), channels);
}

// The error for a file; "" if it can be read.
std::string problem(const std::string& path, const std::string& layer = "") {
  try {
    PictureFile file(path, layer);
    file.read(file.data_window());
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(PictureFile, ReadsAWindowInTheFilesCoordinates) {
  const TemporaryFolder folder;
  Imf::Header header = header_of({"R", "G", "B", "A"});
  header.dataWindow() = Imath::Box2i({5, 7}, {8, 9});
  write(folder / "a.exr", header, {"R", "G", "B"});
  PictureFile file(folder / "a.exr");
  EXPECT_EQ(file.data_window(), (PixelWindow{5, 7, 9, 10}));
  const PixelBlock block = file.read({6, 8, 8, 10});
  EXPECT_THAT(block.colour[0], ElementsAre(11, 12, 21, 22));
  EXPECT_THAT(block.colour[2], ElementsAre(211, 212, 221, 222));
  EXPECT_THROW(file.read({4, 7, 9, 10}), std::invalid_argument);
}

TEST(PictureFile, ReadsTiles) {
  const TemporaryFolder folder;
  Imf::Header header = header_of({"R", "G", "B"});
  header.setTileDescription(Imf::TileDescription(2, 2));
  {
    Values values({"R", "G", "B"});
    Imf::TiledOutputFile file((folder / "tiles.exr").c_str(), header);
    file.setFrameBuffer(values.buffer(header.dataWindow()));
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
  }
  PictureFile file(folder / "tiles.exr");
  EXPECT_FALSE(file.half());
  EXPECT_THAT(file.read({1, 1, 4, 2}).colour[1], ElementsAre(111, 112, 113));
}

TEST(PictureFile, KnowsHalfFloats) {
  const TemporaryFolder folder;
  {
    const Imf::Header header = header_of({"R", "G", "B"}, Imf::HALF);
    std::vector<Imath::half> twos(width * height, Imath::half(2));
    Imf::FrameBuffer frame;
    for (const char* name : {"R", "G", "B"})
      frame.insert(name, Imf::Slice::Make(Imf::HALF, twos.data(), header.dataWindow()));
    Imf::OutputFile file((folder / "half.exr").c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(height);
  }
  PictureFile file(folder / "half.exr");
  EXPECT_TRUE(file.half());
  EXPECT_THAT(file.read({0, 0, 1, 1}).colour[0], ElementsAre(2));
}

TEST(PictureFile, FindsALayerAndAsksWhichOfSeveral) {
  const TemporaryFolder folder;
  write(folder / "one.exr", {"View.Combined.R", "View.Combined.G", "View.Combined.B"});
  EXPECT_THAT(PictureFile(folder / "one.exr").channels(),
              ElementsAre("View.Combined.R", "View.Combined.G", "View.Combined.B"));
  write(folder / "two.exr", {"a.R", "a.G", "a.B", "b.R", "b.G", "b.B"});
  EXPECT_THAT(problem(folder / "two.exr"), HasSubstr("several pictures: \"a\", \"b\" (choose one by --layer)"));
  EXPECT_THAT(problem(folder / "two.exr", "c"), HasSubstr("no layer or part \"c\""));
  EXPECT_THAT(PictureFile(folder / "two.exr", "b").read({0, 0, 1, 1}).colour[0], ElementsAre(300));
  write(folder / "plain.exr", {"R", "G", "B", "b.R", "b.G", "b.B"});
  EXPECT_EQ(PictureFile(folder / "plain.exr").channels()[0], "R") << "the renderer's result";
}

TEST(PictureFile, ReadsThePartThatHoldsColour) {
  const TemporaryFolder folder;
  std::vector<Imf::Header> headers;
  for (const char* name : {"depth", "left", "right"}) {
    headers.push_back(headers.empty() ? header_of({"Z"}) : header_of({"R", "G", "B"}));
    headers.back().setName(name);
    headers.back().setType(Imf::SCANLINEIMAGE);
  }
  const auto write_parts = [&](const std::string& path, int parts) {
    Imf::MultiPartOutputFile file(path.c_str(), headers.data(), parts);
    for (int i = 0; i < parts; ++i) {
      Values values(i == 0 ? std::vector<std::string>{"Z"} : std::vector<std::string>{"R", "G", "B"});
      Imf::OutputPart part(file, i);
      part.setFrameBuffer(values.buffer(headers[0].dataWindow()));
      part.writePixels(height);
    }
  };
  write_parts(folder / "one.exr", 2);
  EXPECT_THAT(PictureFile(folder / "one.exr").read({3, 2, 4, 3}).colour[1], ElementsAre(123));
  write_parts(folder / "two.exr", 3);
  EXPECT_THAT(problem(folder / "two.exr"), HasSubstr("\"left\", \"right\""));
  EXPECT_EQ(problem(folder / "two.exr", "right"), "");
}

TEST(PictureFile, RefusesByNameWhatItCannotRead) {
  const TemporaryFolder folder;
  write(folder / "y.exr", {"Y"});
  EXPECT_THAT(problem(folder / "y.exr"), HasSubstr("y.exr\" holds luminance alone"));
  write(folder / "yc.exr", {"Y", "RY", "BY"});
  EXPECT_THAT(problem(folder / "yc.exr"), HasSubstr("luminance and chroma"));
  write(folder / "z.exr", {"Z"});
  EXPECT_THAT(problem(folder / "z.exr"), HasSubstr("has no channels R, G, B"));
  Imf::OutputFile(((folder / "uint.exr").c_str()), header_of({"R", "G", "B"}, Imf::UINT));
  EXPECT_THAT(problem(folder / "uint.exr"), HasSubstr("whole numbers in R"));
  Imf::Header sampled = header_of({"R", "G", "B"});
  sampled.channels().insert("B", Imf::Channel(Imf::FLOAT, 2, 1));
  Imf::OutputFile(((folder / "sampled.exr").c_str()), sampled);
  EXPECT_THAT(problem(folder / "sampled.exr"), HasSubstr("fewer samples than pixels in B"));
  testing::write_file(folder / "text.exr", "no picture");
  EXPECT_THAT(problem(folder / "text.exr"), HasSubstr("text.exr\" cannot be read as OpenEXR"));
  EXPECT_THAT(problem(folder / "none.exr"), HasSubstr("there is no file"));
  EXPECT_THAT(problem(folder.path().string()), HasSubstr("there is no file"));
}

TEST(PictureFile, RefusesDeepPixels) {
  const TemporaryFolder folder;
  Imf::Header header = header_of({"R", "G", "B"});
  header.setType(Imf::DEEPSCANLINE);
  header.compression() = Imf::ZIPS_COMPRESSION;
  Imf::DeepScanLineOutputFile(((folder / "deep.exr").c_str()), header);
  EXPECT_THAT(problem(folder / "deep.exr"), HasSubstr("deep pixels"));
}

TEST(PictureFile, RefusesAHeaderOfTooManyPixelsBeforeItTakesMemory) {
  const TemporaryFolder folder;
  Imf::Header header = header_of({"R", "G", "B"});
  header.dataWindow() = header.displayWindow() = Imath::Box2i({0, 0}, {99999, 0});
  Imf::OutputFile(((folder / "wide.exr").c_str()), header);
  EXPECT_THAT(problem(folder / "wide.exr"), HasSubstr("has 100000 x 1 pixels"));
}

TEST(PictureFile, RefusesATruncatedFile) {
  const TemporaryFolder folder;
  write(folder / "a.exr", {"R", "G", "B"});
  std::string bytes = testing::read_file(folder / "a.exr");
  for (const std::size_t length : {bytes.size() - 20, bytes.size() / 2, std::size_t{40}, std::size_t{0}}) {
    testing::write_file(folder / "cut.exr", bytes.substr(0, length));
    EXPECT_THAT(problem(folder / "cut.exr"), HasSubstr("cut.exr\"")) << length;
  }
}

TEST(PictureFile, FindsTheErrorLayersOfThreeRenderers) {
  const TemporaryFolder folder;
  write_exr(folder / "ours.exr", testing::small_picture());
  PictureFile ours(folder / "ours.exr");
  EXPECT_EQ(ours.error_layer(), ErrorLayer::standard_error);
  EXPECT_THAT(ours.read({1, 0, 2, 1}).samples, ElementsAre(2));
  EXPECT_THAT(ours.attribute("fairlight.scene"), "cornell-simple");

  Imf::Header pbrt =
      header_of({"R", "G", "B", "Variance.R", "Variance.G", "Variance.B", "Albedo.R", "Albedo.G", "Albedo.B"});
  pbrt.insert("samplesPerPixel", Imf::IntAttribute(16));
  write(folder / "pbrt.exr", pbrt, {"R", "G", "B"});
  const PictureFile gbuffer(folder / "pbrt.exr");
  EXPECT_EQ(gbuffer.error_layer(), ErrorLayer::variance);
  EXPECT_EQ(gbuffer.samples_per_pixel(), 16);
  EXPECT_EQ(gbuffer.channels()[0], "R");

  write(folder / "mitsuba.exr",
        {"R", "G", "B", "path.X", "path.Y", "path.Z", "m2_path.X", "m2_path.Y", "m2_path.Z"});
  EXPECT_EQ(PictureFile(folder / "mitsuba.exr").error_layer(), ErrorLayer::none) << "its R, G, B have none";
  PictureFile moments(folder / "mitsuba.exr", "", true);
  EXPECT_EQ(moments.error_layer(), ErrorLayer::second_moment);
  EXPECT_EQ(moments.channel_letters(), "XYZ");
  const PixelBlock block = moments.read({2, 1, 3, 2});
  EXPECT_THAT(block.colour[0], ElementsAre(312));
  EXPECT_THAT(block.error[2], ElementsAre(812));
}

TEST(PictureFile, KnowsThePrimaries) {
  const TemporaryFolder folder;
  Imf::Header header = header_of({"R", "G", "B"});
  write(folder / "rec709.exr", header, {"R", "G", "B"});
  EXPECT_NEAR(PictureFile(folder / "rec709.exr").chromaticities()[0], 0.64, 1e-7);
  header.insert("chromaticities", Imf::ChromaticitiesAttribute(
                                      {{0.713f, 0.293f}, {0.165f, 0.83f}, {0.128f, 0.044f}, {0.32168f, 0.33767f}}));
  write(folder / "acescg.exr", header, {"R", "G", "B"});
  EXPECT_NEAR(PictureFile(folder / "acescg.exr").chromaticities()[7], 0.33767, 1e-7);
}

}  // namespace
}  // namespace fairlight

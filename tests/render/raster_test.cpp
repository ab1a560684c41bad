#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <gtest/gtest.h>
#include <support/temporary_folder.h>

#include <fairlight/render/raster.h>

namespace fairlight {
namespace {

using testing::TemporaryFolder;

TEST(Raster, KeepsEveryPlaneOfAnExr) {
  const TemporaryFolder folder;
  write_exr(folder / "a.exr", 3, 2, {{"p", {1, 2, 3, 4, 5, 6}}, {"q", {6, 5, 4, 3, 2, 1}}});
  Imf::InputFile file((folder / "a.exr").c_str());
  std::vector<float> values(6);
  Imf::FrameBuffer buffer;
  buffer.insert("p",
                Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float), 3 * sizeof(float)));
  file.setFrameBuffer(buffer);
  file.readPixels(0, 1);
  EXPECT_EQ(values, (std::vector<float>{1, 2, 3, 4, 5, 6}));
  EXPECT_TRUE(file.header().channels().findChannel("q") != nullptr);
}

TEST(Raster, RefusesValuesThatAreNotAsManyAsThePixels) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_exr(folder / "a.exr", 3, 2, {{"p", {1, 2}}}), std::invalid_argument);
  const std::vector<std::uint8_t> bytes(17);
  EXPECT_THROW(write_png(folder / "a.png", 3, 2, bytes), std::invalid_argument);
  EXPECT_EQ(folder.files(), 0);
}

}  // namespace
}  // namespace fairlight

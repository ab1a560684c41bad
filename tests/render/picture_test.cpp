#include <stdexcept>

#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfMultiPartInputFile.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>
#include <support/small_picture.h>
#include <support/temporary_folder.h>

#include <fairlight/render/picture.h>

namespace fairlight {
namespace {

using testing::read_file;
using testing::small_picture;
using testing::TemporaryFolder;
using testing::write_file;

TEST(Picture, IsReadAsItWasWritten) {
  const TemporaryFolder folder;
  const Picture picture = small_picture();
  write_exr(folder / "a.exr", picture);
  const Picture back = read_exr(folder / "a.exr");
  EXPECT_EQ(back.film, picture.film);
  EXPECT_EQ(nlohmann::json(back.settings), nlohmann::json(picture.settings));
  EXPECT_EQ(back.samples.json(), picture.samples.json());
  EXPECT_EQ(folder.files(), 1);
}

TEST(Picture, ShowsRadianceErrorAndSamplesToOtherPrograms) {
  const TemporaryFolder folder;
  write_exr(folder / "a.exr", small_picture());
  Imf::MultiPartInputFile file((folder / "a.exr").c_str());
  const Imf::ChannelList& channels = file.header(0).channels();
  for (const char* name : {"R", "G", "B", "error.R", "error.G", "error.B", "samples.N"}) {
    EXPECT_NE(channels.findChannel(name), nullptr) << name;
  }
  for (const char* name : {"scene", "settings", "seed", "version", "checksum"}) {
    EXPECT_NE(file.header(0).findTypedAttribute<Imf::StringAttribute>(std::string("fairlight.") + name), nullptr)
        << name;
  }
}

TEST(Picture, MergesToTheSameBytesInAnyOrder) {
  const TemporaryFolder folder;
  Picture ab = small_picture(0);
  ab.merge(small_picture(2));
  Picture ba = small_picture(2);
  ba.merge(small_picture(0));
  write_exr(folder / "ab.exr", ab);
  write_exr(folder / "ba.exr", ba);
  EXPECT_EQ(read_file(folder / "ab.exr"), read_file(folder / "ba.exr"));
}

TEST(Picture, RefusesToMergeTheSameSamplesOrOtherSettings) {
  Picture picture = small_picture();
  EXPECT_THROW(picture.merge(small_picture()), std::invalid_argument);
  Picture other = small_picture(2);
  other.settings.bounce = BounceSampling::uniform;
  EXPECT_THROW(picture.merge(other), std::invalid_argument);
}

TEST(ReadExr, RefusesEveryTruncation) {
  const TemporaryFolder folder;
  write_exr(folder / "a.exr", small_picture());
  const std::string bytes = read_file(folder / "a.exr");
  for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 64) {
    write_file(folder / "cut.exr", bytes.substr(0, size));
    EXPECT_THROW(read_exr(folder / "cut.exr"), std::runtime_error) << size << " of " << bytes.size() << " bytes";
  }
}

TEST(ReadExr, RefusesSamplesThatWereNotCounted) {
  const TemporaryFolder folder;
  Picture claims_more = small_picture();
  claims_more.samples.add(42, {7, 9});
  write_exr(folder / "more.exr", claims_more);
  EXPECT_THROW(read_exr(folder / "more.exr"), std::runtime_error);
}

TEST(ReadExr, RefusesForeignAndMissingFiles) {
  const TemporaryFolder folder;
  write_file(folder / "text.exr", "this is not a picture");
  EXPECT_THROW(read_exr(folder / "text.exr"), std::runtime_error);
  EXPECT_THROW(read_exr(folder / "missing.exr"), std::runtime_error);
  EXPECT_THROW(read_exr(folder.path().string()), std::runtime_error);
}

TEST(WritePng, WritesAPng) {
  const TemporaryFolder folder;
  write_png(folder / "a.png", small_picture().film);
  EXPECT_EQ(read_file(folder / "a.png").substr(1, 3), "PNG");
  EXPECT_EQ(folder.files(), 1);
}

}  // namespace
}  // namespace fairlight

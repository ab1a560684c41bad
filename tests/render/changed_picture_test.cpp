#include <algorithm>
#include <bit>
#include <functional>
#include <map>
#include <stdexcept>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>
#include <support/small_picture.h>
#include <support/temporary_folder.h>

#include <fairlight/render/picture.h>

namespace fairlight {
namespace {

using testing::small_picture;
using testing::TemporaryFolder;

// What another program makes of a file: every attribute and channel is kept, of which sums and light go through `change`.
class SavedAgain {
 public:
  using Plane = std::vector<std::uint32_t>;

  SavedAgain(const std::string& path, Imf::PixelType sums_type = Imf::UINT) : file_(path.c_str()) {
    for (int part = 0; part < file_.parts(); ++part) {
      headers_.push_back(file_.header(part));
      if (part == 0 || sums_type == Imf::UINT) continue;
      Imf::ChannelList channels;
      for (auto i = file_.header(part).channels().begin(); i != file_.header(part).channels().end(); ++i)
        channels.insert(i.name(), Imf::Channel(sums_type));
      headers_.back().channels() = channels;
    }
  }

  std::vector<Imf::Header>& headers() { return headers_; }

  // `change` gets each plane of 32-bit words, which for most channels of the light are floats.
  void write(const std::string& path, const std::function<void(Plane&, int part)>& change) {
    Imf::MultiPartOutputFile out(path.c_str(), headers_.data(), static_cast<int>(headers_.size()));
    for (int part = 0; part < static_cast<int>(headers_.size()); ++part) copy(out, part, change);
  }

 private:
  // Planes are read as they are in the old file, and written as the new one has them.
  void copy(Imf::MultiPartOutputFile& out, int part, const std::function<void(Plane&, int)>& change) {
    const Imath::Box2i from = file_.header(part).dataWindow(),
                       to = headers_[static_cast<std::size_t>(part)].dataWindow();
    const auto width = static_cast<std::size_t>(from.max.x + 1);
    const Imf::ChannelList& channels = file_.header(part).channels();
    std::map<std::string, Plane> planes;
    Imf::FrameBuffer in, buffer;
    for (auto i = channels.begin(); i != channels.end(); ++i) {
      Plane& plane = planes[i.name()];
      plane.resize(width * static_cast<std::size_t>(from.max.y + 1));
      const auto slice = [&](Imf::PixelType type) {
        return Imf::Slice(type, reinterpret_cast<char*>(plane.data()), sizeof(std::uint32_t),
                          width * sizeof(std::uint32_t));
      };
      in.insert(i.name(), slice(i.channel().type));
      buffer.insert(i.name(), slice(headers_[static_cast<std::size_t>(part)].channels()[i.name()].type));
    }
    Imf::InputPart input(file_, part);
    input.setFrameBuffer(in);
    input.readPixels(from.min.y, from.max.y);
    for (auto& [name, plane] : planes) change(plane, part);
    Imf::OutputPart output(out, part);
    output.setFrameBuffer(buffer);
    output.writePixels(to.max.y - to.min.y + 1);
  }

  Imf::MultiPartInputFile file_;
  std::vector<Imf::Header> headers_;
};

void keep(SavedAgain::Plane&, int) {}
void mirror(SavedAgain::Plane& plane, int) {
  for (auto row = plane.begin(); row != plane.end(); row += 5) std::reverse(row, row + 5);
}

std::string refusal(const std::string& path) {
  try {
    read_exr(path);
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

class SavedAgainTest : public ::testing::Test {
 protected:
  SavedAgainTest() { write_exr(old_, small_picture()); }
  void expect_refused() {
    EXPECT_EQ(refusal(new_),
              "\"" + new_ + "\" was changed by another program (give the file as fairlight wrote it)");
  }
  TemporaryFolder folder_;
  std::string old_ = folder_ / "old.exr", new_ = folder_ / "new.exr";
};

// Else what follows could say nothing.
TEST_F(SavedAgainTest, IsReadWhereNothingWasChanged) {
  SavedAgain(old_).write(new_, keep);
  EXPECT_EQ(read_exr(new_).film, small_picture().film);
}

TEST_F(SavedAgainTest, IsRefusedRoundedToFloats) {
  SavedAgain file(old_, Imf::FLOAT);
  file.write(new_, [](SavedAgain::Plane& plane, int part) {
    if (part == 0) return;
    for (std::uint32_t& word : plane) word = std::bit_cast<std::uint32_t>(static_cast<float>(word));
  });
  expect_refused();
}

TEST_F(SavedAgainTest, IsRefusedMirrored) {
  SavedAgain(old_).write(new_, mirror);
  expect_refused();
}

TEST_F(SavedAgainTest, IsRefusedCropped) {
  SavedAgain file(old_);
  for (Imf::Header& header : file.headers()) header.dataWindow() = {{0, 0}, {4, 1}};
  file.write(new_, keep);
  expect_refused();
}

TEST_F(SavedAgainTest, IsRefusedWithoutItsSums) {
  SavedAgain file(old_);
  file.headers().pop_back();
  file.write(new_, keep);
  expect_refused();
}

TEST_F(SavedAgainTest, IsRefusedWithAnyBitOfTheSumsChanged) {
  for (int changed = 0; changed < 60; changed += 7) {
    int plane_number = 0;
    SavedAgain(old_).write(new_, [&](SavedAgain::Plane& plane, int part) {
      if (part == 1 && plane_number++ == changed)
        plane[static_cast<std::size_t>(changed % 15)] ^= 1u << changed % 32;
    });
    expect_refused();
  }
}

TEST_F(SavedAgainTest, IsRefusedWithOtherSettingsOrSamples) {
  RenderSettings other = small_picture().settings;
  other.bounce = BounceSampling::uniform;
  const std::vector<std::pair<const char*, std::string>> changes{
      {"fairlight.settings", nlohmann::json(other).dump()},
      {"fairlight.scene", "cornell-original"},
      {"fairlight.seed", R"({"000000000000002a":[[2,4]]})"},
      {"fairlight.seed", R"({"000000000000002b":[[0,2]]})"},
      {"fairlight.checksum", "0000000000000000"}};
  for (const auto& [name, text] : changes) {
    SavedAgain file(old_);
    file.headers()[0].insert(name, Imf::StringAttribute(text));
    file.write(new_, keep);
    SCOPED_TRACE(name);
    expect_refused();
  }
}

// As those of earlier versions are.
TEST_F(SavedAgainTest, IsRefusedWithoutAChecksum) {
  SavedAgain file(old_);
  file.headers()[0].erase("fairlight.checksum");
  file.write(new_, keep);
  EXPECT_EQ(refusal(new_),
            "\"" + new_ + "\" has no checksum, as of an earlier version of fairlight (render it again)");
}

}  // namespace
}  // namespace fairlight

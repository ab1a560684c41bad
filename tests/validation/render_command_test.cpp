#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/temporary_folder.h>

#include <fairlight/render/file_lock.h>
#include <fairlight/render/picture.h>
#include <fairlight/validation/app/render_command.h>

namespace fairlight {
namespace {

using ::testing::HasSubstr;
using testing::read_file;
using testing::TemporaryFolder;

// Runs a command as the program does; what it refuses is returned.
std::string run(const std::string& line) {
  CLI::App program;
  Command command;
  add_render_commands(program, command);
  program.parse(line);
  try {
    command();
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

std::string render(const TemporaryFolder& folder, const std::string& options) {
  return run("render cornell-simple --width 8 --height 8 --seed 1 -o " + (folder / "a.exr") + " " + options);
}

// From before the resumed file is read: the other run may replace it meanwhile.
TEST(RenderCommand, RefusesAnOutputThatAnotherRunWrites) {
  const TemporaryFolder folder;
  ASSERT_EQ(render(folder, "--spp 1"), "");
  const std::string before = read_file(folder / "a.exr");
  const std::string a = folder / "a.exr", another = "\"" + a + "\" is being written by another run";
  {
    const OutputLock lock(a);
    EXPECT_THAT(render(folder, "--spp 1 --resume " + a), HasSubstr(another));
    EXPECT_THAT(run("merge " + a + " -o " + a), HasSubstr(another));
  }
  EXPECT_EQ(read_file(a), before);
  EXPECT_EQ(folder.files(), 1);
  EXPECT_EQ(render(folder, "--spp 1 --resume " + a), "");
}

// A shard may be far from the samples that a picture holds: what follows them are other samples, not the first ones again.
TEST(RenderCommand, GoesOnBeyondTwoToThe32Samples) {
  const TemporaryFolder folder;
  const std::string a = folder / "a.exr";
  ASSERT_EQ(render(folder, "--spp 8"), "");
  const Picture first = read_exr(a);
  Picture far{first.settings, {}, first.film};
  far.samples.add(1, {(std::uint64_t{1} << 32) - 8, std::uint64_t{1} << 32});
  write_exr(a, far);
  ASSERT_EQ(render(folder, "--spp 8 --resume " + a), "");
  Film twice = first.film;
  twice.merge(first.film);
  const Picture resumed = read_exr(a);
  EXPECT_EQ(resumed.samples.json().dump(), R"({"0000000000000001":[[4294967288,4294967304]]})");
  EXPECT_NE(resumed.film, twice);
}

TEST(RenderCommand, RefusesToGoOnWhereASeedHasNoMoreSamples) {
  const TemporaryFolder folder;
  const std::string a = folder / "a.exr";
  constexpr std::uint64_t end = std::numeric_limits<std::uint64_t>::max();
  ASSERT_EQ(render(folder, "--spp 8"), "");
  Picture last = read_exr(a);
  last.samples = {};
  last.samples.add(1, {end - 8, end});
  write_exr(a, last);
  EXPECT_THAT(render(folder, "--spp 1 --resume " + a), HasSubstr("samples of this seed have run out"));
}

}  // namespace
}  // namespace fairlight

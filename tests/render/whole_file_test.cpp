#include <stdexcept>

#include <gtest/gtest.h>
#include <support/temporary_folder.h>

#include <fairlight/render/whole_file.h>

namespace fairlight {
namespace {

using testing::read_file;
using testing::TemporaryFolder;

TEST(WholeFile, IsThereOnlyAfterCommit) {
  const TemporaryFolder folder;
  const std::string path = folder / "out";
  WholeFile file(path);
  file.write(std::string("hello"));
  EXPECT_FALSE(std::filesystem::exists(path));
  file.commit();
  EXPECT_EQ(read_file(path), "hello");
  EXPECT_EQ(folder.files(), 1);
}

TEST(WholeFile, LeavesWhatWasThereWhenItIsGivenUp) {
  const TemporaryFolder folder;
  testing::write_file(folder / "out", "old");
  {
    WholeFile file(folder / "out");
    file.write(std::string("new"));
  }
  EXPECT_EQ(read_file(folder / "out"), "old");
  EXPECT_EQ(folder.files(), 1);
}

TEST(WholeFile, CanSeek) {
  const TemporaryFolder folder;
  WholeFile file(folder / "out");
  file.write(std::string("abcdef"));
  file.seek(1);
  file.write(std::string("X"));
  EXPECT_EQ(file.position(), 2u);
  file.commit();
  EXPECT_EQ(read_file(folder / "out"), "aXcdef");
}

TEST(WholeFile, RefusesAFolderThatDoesNotExistAndWhatIsNoFile) {
  const TemporaryFolder folder;
  EXPECT_THROW(WholeFile(folder / "missing/out"), std::runtime_error);
  EXPECT_THROW(WholeFile(folder.path().string()), std::runtime_error);
  for (const char* path : {"/dev/full", "/dev/stdout", "/dev/new", "/proc/self/fd/1", ""}) {
    EXPECT_THROW(WholeFile{path}, std::runtime_error) << path;
  }
  EXPECT_EQ(folder.files(), 0);
}

TEST(WholeFile, FollowsALinkAndLeavesItALink) {
  const TemporaryFolder folder;
  testing::write_file(folder / "target", "old");
  std::filesystem::create_symlink("target", folder / "link");
  WholeFile file(folder / "link");
  file.write(std::string("new"));
  file.commit();
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(read_file(folder / "target"), "new");
}

TEST(WholeFile, ChecksWithoutATrace) {
  const TemporaryFolder folder;
  WholeFile::check_writable(folder / "out");
  EXPECT_EQ(folder.files(), 0);
}

}  // namespace
}  // namespace fairlight

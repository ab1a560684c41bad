#include <stdexcept>

#include <gtest/gtest.h>
#include <support/temporary_folder.h>

#include <fairlight/render/atomic_file.h>

namespace fairlight {
namespace {

using testing::read_file;
using testing::TemporaryFolder;

TEST(AtomicFile, IsThereOnlyAfterCommit) {
  const TemporaryFolder folder;
  const std::string path = folder / "out";
  AtomicFile file(path);
  file.write(std::string("hello"));
  EXPECT_FALSE(std::filesystem::exists(path));
  file.commit();
  EXPECT_EQ(read_file(path), "hello");
  EXPECT_EQ(folder.files(), 1);
}

TEST(AtomicFile, LeavesWhatWasThereWhenItIsGivenUp) {
  const TemporaryFolder folder;
  testing::write_file(folder / "out", "old");
  {
    AtomicFile file(folder / "out");
    file.write(std::string("new"));
  }
  EXPECT_EQ(read_file(folder / "out"), "old");
  EXPECT_EQ(folder.files(), 1);
}

TEST(AtomicFile, CanSeek) {
  const TemporaryFolder folder;
  AtomicFile file(folder / "out");
  file.write(std::string("abcdef"));
  file.seek(1);
  file.write(std::string("X"));
  EXPECT_EQ(file.position(), 2u);
  file.commit();
  EXPECT_EQ(read_file(folder / "out"), "aXcdef");
}

TEST(AtomicFile, RefusesAFolderThatDoesNotExistAndWhatIsNoFile) {
  const TemporaryFolder folder;
  EXPECT_THROW(AtomicFile(folder / "missing/out"), std::runtime_error);
  EXPECT_THROW(AtomicFile(folder.path().string()), std::runtime_error);
  for (const char* path : {"/dev/full", "/dev/stdout", "/dev/new", "/proc/self/fd/1", ""}) {
    EXPECT_THROW(AtomicFile{path}, std::runtime_error) << path;
  }
  EXPECT_EQ(folder.files(), 0);
}

TEST(AtomicFile, FollowsALinkAndLeavesItALink) {
  const TemporaryFolder folder;
  testing::write_file(folder / "target", "old");
  std::filesystem::create_symlink("target", folder / "link");
  AtomicFile file(folder / "link");
  file.write(std::string("new"));
  file.commit();
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(read_file(folder / "target"), "new");
}

TEST(AtomicFile, ChecksWithoutATrace) {
  const TemporaryFolder folder;
  AtomicFile::check_writable(folder / "out");
  EXPECT_EQ(folder.files(), 0);
}

}  // namespace
}  // namespace fairlight

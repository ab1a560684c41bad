#include <atomic>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/temporary_folder.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fairlight/render/atomic_file.h>
#include <fairlight/render/file_lock.h>
#include <fairlight/stats/text.h>

namespace fairlight {
namespace {

using ::testing::HasSubstr;
using testing::read_file;
using testing::TemporaryFolder;
using testing::write_file;

std::string refusal(const std::string& path) {
  try {
    const OutputLock lock(path);
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(OutputLock, IsOneRunsAloneAndLeavesNothing) {
  const TemporaryFolder folder;
  {
    const OutputLock lock(folder / "a.exr");
    EXPECT_EQ(refusal(folder / "a.exr"),
              formatted("\"%s\" is being written by another run (wait for it, or give another -o)",
                        std::string(folder / "a.exr").c_str()));
    EXPECT_EQ(refusal(folder / "b.exr"), "") << "another output";
  }
  EXPECT_EQ(refusal(folder / "a.exr"), "");
  EXPECT_EQ(folder.files(), 0);
}

// The file has another inode after it was replaced, and the lock holds all the same.
TEST(OutputLock, OutlivesTheFileThatIsReplaced) {
  const TemporaryFolder folder;
  write_file(folder / "a.exr", "old");
  const OutputLock lock(folder / "a.exr");
  write_whole(folder / "a.exr", std::string("new"));
  EXPECT_THAT(refusal(folder / "a.exr"), HasSubstr("another run"));
}

TEST(OutputLock, IsThatOfTheFileBehindALink) {
  const TemporaryFolder folder;
  write_file(folder / "a.exr", "old");
  std::filesystem::create_symlink("a.exr", folder / "link.exr");
  std::filesystem::create_directory_symlink(folder.path(), folder / "here");
  const OutputLock lock(folder / "link.exr");
  EXPECT_THAT(refusal(folder / "a.exr"), HasSubstr("another run"));
  EXPECT_THAT(refusal(folder / "here/a.exr"), HasSubstr("another run"));
}

// The system takes the lock from a process that is killed, which cannot remove its file.
TEST(OutputLock, IsNotLeftBehindByAProcessThatIsKilled) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.exr";
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const OutputLock lock(path);
    if (write(ready[1], "x", 1) != 1) _exit(1);
    while (true) pause();
  }
  char byte = 0;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  EXPECT_THAT(refusal(path), HasSubstr("another run"));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  close(ready[0]);
  close(ready[1]);
  EXPECT_EQ(refusal(path), "");
  EXPECT_EQ(folder.files(), 0);
}

// Runs that add one to a file, each as soon as it has the lock: none is lost, though the lock's file comes and goes.
TEST(OutputLock, LosesNothingOfManyRunsAtOnce) {
  const TemporaryFolder folder;
  const std::string path = folder / "count";
  write_file(path, "0");
  std::atomic<int> added = 0;
  const auto run = [&] {
    for (int i = 0; i < 3000; ++i) {
      try {
        const OutputLock lock(path);
        write_file(path, std::to_string(std::atoi(read_file(path).c_str()) + 1));
        ++added;
      } catch (const std::runtime_error& error) {
        ASSERT_THAT(error.what(), HasSubstr("another run"));
      }
    }
  };
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) threads.emplace_back(run);
  for (std::thread& thread : threads) thread.join();
  EXPECT_GT(added, 0);
  EXPECT_EQ(std::atoi(read_file(path).c_str()), added);
}

TEST(OutputLock, TouchesNoFileOfSomebodyElse) {
  const TemporaryFolder folder;
  write_file(folder / "a.exr.lock", "mine");
  EXPECT_THAT(refusal(folder / "a.exr"), HasSubstr("in the way"));
  EXPECT_EQ(read_file(folder / "a.exr.lock"), "mine");
  EXPECT_THAT(refusal(folder / "missing/a.exr"), HasSubstr("cannot write"));
}

}  // namespace
}  // namespace fairlight

#pragma once

#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <support/temporary_folder.h>
#include <sys/wait.h>

/// Runs the program as a user does, to check its exit status, its one sentence on standard error,
/// and that it leaves no incomplete file.
namespace fairlight::testing {

struct Result {
  int status;
  std::string out, error;
};

inline Result shell(const std::string& command, const TemporaryFolder& folder) {
  const std::string out = folder / "stdout";
  const std::string error = folder / "stderr";
  const int status =
      std::system(("cd '" + folder.path().string() + "' && { " + command + "; } >stdout 2>stderr").c_str());
  const Result run{WEXITSTATUS(status), read_file(out), read_file(error)};
  std::filesystem::remove(out);
  std::filesystem::remove(error);
  return run;
}

inline Result fairlight(const std::string& arguments, const TemporaryFolder& folder) {
  return shell(FAIRLIGHT_PROGRAM " " + arguments, folder);
}

inline void expect_bad_input(const std::string& arguments, const std::string& says) {
  const TemporaryFolder folder;
  const Result run = fairlight(arguments, folder);
  EXPECT_EQ(run.status, 2) << arguments;
  EXPECT_TRUE(run.error.starts_with("fairlight: ")) << arguments << "\n" << run.error;
  EXPECT_EQ(std::count(run.error.begin(), run.error.end(), '\n'), 1) << arguments << "\n" << run.error;
  EXPECT_NE(run.error.find(says), std::string::npos) << arguments << "\n" << run.error;
  EXPECT_EQ(folder.files(), 0) << arguments;
}

}  // namespace fairlight::testing

#pragma once

#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <support/shell.h>

/// Runs the program as a user does, to check its exit status, its one sentence on standard error,
/// and that it leaves no incomplete file.
namespace fairlight::testing {

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

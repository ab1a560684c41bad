#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include <support/temporary_folder.h>
#include <sys/wait.h>

namespace fairlight::testing {

/// The exit status and the output of a command.
struct Result {
  int status;
  std::string out, error;
};

/// Runs a command of the shell in a folder.
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

}  // namespace fairlight::testing

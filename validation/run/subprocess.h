#pragma once

#include <string>
#include <vector>

namespace fairlight {

struct ProcessResult {
  int status;         ///< exit status, or 128 plus the number of the signal that ended it
  std::string out;    ///< its standard output
  std::string error;  ///< its standard error
};

/// Runs a program, found on the PATH. The first argument is its name; no shell reads the arguments.
/// Its input is empty. Throws std::runtime_error if it cannot be started.
ProcessResult run_process(const std::vector<std::string>& arguments);

}  // namespace fairlight

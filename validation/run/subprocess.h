#pragma once

#include <string>
#include <vector>

namespace fairlight {

struct ProcessResult {
  int status;       ///< exit status; 128 or more where a signal ended it
  std::string out;  ///< its standard output
};

/// Runs a program, which is looked for on the PATH, with these arguments, the first its own name: no shell reads them. It has no
/// input, and what it says on standard error is dropped. Throws std::runtime_error when it cannot be started.
ProcessResult run_process(const std::vector<std::string>& arguments);

}  // namespace fairlight

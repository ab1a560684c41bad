#pragma once

#include <map>
#include <string>
#include <vector>

#include <fairlight/validation/run/run_claims.h>

namespace fairlight {

/// A run as a page for people.
struct Page {
  const std::vector<Outcome>& outcomes;
  const RunOptions& run_options;
  double seconds;
  std::string command;                                       ///< that runs it all again
  std::string overview;                                      ///< the picture of all intervals; or empty
  std::map<std::string, std::vector<std::string>> pictures;  ///< of a claim, by its label
};

/// The page as Markdown: the verdict, what was run and how to run it again, every failure with its pictures, then the table of all. Links
/// are relative to the folder of `path`.
std::string markdown(const Page& page, const std::string& path);

}  // namespace fairlight

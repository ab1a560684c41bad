#pragma once

#include <map>
#include <string>
#include <vector>

#include <fairlight/validation/run/components.h>

namespace fairlight {

/// The contents of the page about a run.
struct Page {
  const std::vector<Outcome>& outcomes;
  const std::vector<ComponentOutcome>& components;
  const RunOptions& run_options;
  double seconds;
  std::string command;                                       ///< repeats the run
  std::string overview;                                      ///< the path of the picture of all intervals, or empty
  std::map<std::string, std::vector<std::string>> pictures;  ///< paths, by the label of the claim
};

/// The page as Markdown: the verdict, the claims that ran and how to run them again, every failure
/// with its pictures, then the tables of all claims and of components. Links are relative to the folder of `path`.
std::string markdown(const Page& page, const std::string& path);

}  // namespace fairlight

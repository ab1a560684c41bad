#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <fairlight/validation/studies/study.h>

namespace fairlight {

/// Studies and how they run. Without a seed, one that goes on with an unfinished run has its seed,
/// and any other a fresh one.
struct StudyRun {
  std::vector<std::string> names;  ///< "all" stands for every study
  StudyOptions options;
  std::optional<std::uint64_t> seed;
};

/// Runs studies one after the other, and writes each to the folder as soon as it is done. Until all
/// are done the folder has a file unfinished.json; a run of the same studies, by the same program,
/// goes on where that one was. Several studies also get an index, README.md. Calls `show` with the
/// JSON of each study, and with false if an earlier run had done it. Throws std::invalid_argument
/// for an unknown name, and std::runtime_error for a folder that cannot be written or that another
/// run is writing to.
void run_studies(StudyRun run, const std::function<void(const nlohmann::json&, bool fresh)>& show);

}  // namespace fairlight

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <fairlight/render/parallel.h>
#include <fairlight/stats/ratio.h>

namespace fairlight {

/// How a study runs.
struct StudyOptions {
  std::string folder;  ///< where its pictures go
  std::uint64_t seed = 0;
  bool quick = false;  ///< fewer and smaller samples: a look in seconds
  int threads = 1;
  Progress progress{};
};

/// A value of a table: exact, measured, or a word.
using Cell = std::variant<double, Measured, std::string>;

struct Column {
  std::string name;
  bool of_clock = false;  ///< whether its values depend on the time that something took
};

struct StudyTable {
  std::string name;     ///< of its CSV file, and of its entry in the JSON
  std::string caption;  ///< says what the columns are
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;
};

/// A picture in the study's folder.
struct StudyPicture {
  std::string file, caption;
};

struct StudyResult {
  std::string text;  ///< what was done, and what it shows: Markdown
  std::vector<StudyTable> tables;
  std::vector<StudyPicture> pictures;
};

/// An experiment of the paper, measured again.
struct Study {
  const char* name;
  const char* title;
  const char* source;
  double seconds;  ///< on two quiet cores; about, for the progress bar
  StudyResult (*run)(const StudyOptions&);
};

/// All studies, in the order of the paper.
std::span<const Study> studies();

/// The study of that name. Throws std::invalid_argument, with the nearest names, if there is none.
const Study& study_named(const std::string& name);

/// Reports the progress of a study whose steps take about the same time.
class Steps {
 public:
  Steps(const StudyOptions& options, std::size_t steps) : options_(options), steps_(steps) {}
  void done() {
    if (options_.progress) options_.progress(static_cast<double>(++done_) / static_cast<double>(steps_));
  }

 private:
  const StudyOptions& options_;
  std::size_t steps_, done_ = 0;
};

}  // namespace fairlight

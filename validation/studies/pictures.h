#pragma once

#include <string>
#include <vector>

#include <fairlight/render/film.h>
#include <fairlight/validation/studies/study.h>

namespace fairlight {

/// A picture of a montage, and its caption of one or two lines.
struct Captioned {
  Film film;
  std::string caption;
};

/// Writes the pictures, all of one size, in rows of `columns` with their captions below, as
/// FOLDER/STEM.png. Also STEM-sheet.png, without captions, and STEM.gp, the gnuplot script that sets
/// the captions. `overlay` is more of that script, in pixels of the sheet from its top left. Radiance
/// is multiplied by `exposure`. Throws as write_chart does.
StudyPicture write_montage(const StudyOptions& options, const std::string& stem, const std::string& about,
                           const std::vector<Captioned>& pictures, int columns, const std::string& overlay = "",
                           double exposure = 1);

/// Where picture i of such a montage begins on its sheet, in pixels.
struct SheetPlace {
  int x, y;
};
SheetPlace place_on_sheet(int i, int columns, int width, int height);

/// Writes a map of values, row by row, as FOLDER/STEM.png. `palette` is gnuplot's, `range` that of
/// the colours: "[0:1]"; `setting` is more of the script.
StudyPicture write_map(const StudyOptions& options, const std::string& stem, const std::string& about,
                       const std::vector<double>& values, int across, const std::string& range,
                       const std::string& palette, const std::string& setting = "");

/// Writes a chart by a gnuplot script, which uses the data blocks that it contains.
StudyPicture write_study_chart(const StudyOptions& options, const std::string& stem, const std::string& about,
                               const std::string& title, int width, int height, const char* layout,
                               const std::string& script);

}  // namespace fairlight

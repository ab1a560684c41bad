#include <fairlight/render/picture.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/report/charts.h>
#include <fairlight/validation/studies/pictures.h>

namespace fairlight {
namespace {

constexpr int gap = 6, caption_height = 54;

// Text as a gnuplot string.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '\n' ? std::string("\\n") : c == '"' ? std::string("'") : std::string(1, c);
  return out + "\"";
}

// Sets `here` to the folder of the script, so that it can be run from any folder.
constexpr const char* find_folder =
    "here = ARG0\nwhile (strlen(here) > 0 && here[strlen(here):*] ne '/') { here = here[1:strlen(here) - 1] }\n";

Film sheet_of(const std::vector<Captioned>& pictures, int columns, double exposure) {
  const int n = static_cast<int>(pictures.size()), width = pictures[0].film.width(),
            height = pictures[0].film.height();
  const auto [last_x, last_y] = place_on_sheet((n - 1) / columns * columns + columns - 1, columns, width, height);
  Film sheet(last_x + width + gap, last_y + height + caption_height);
  for (int i = 0; i < n; ++i) {
    const Film& film = pictures[static_cast<std::size_t>(i)].film;
    const auto [left, top] = place_on_sheet(i, columns, width, height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) sheet.add(left + x, top + y, film.mean(x, y) * exposure);
    }
  }
  return sheet;
}

}  // namespace

SheetPlace place_on_sheet(int i, int columns, int width, int height) {
  return {gap + i % columns * (width + gap), gap + i / columns * (height + caption_height)};
}

StudyPicture write_montage(const StudyOptions& options, const std::string& stem, const std::string& about,
                           const std::vector<Captioned>& pictures, int columns, const std::string& overlay,
                           double exposure) {
  const Film sheet = sheet_of(pictures, columns, exposure);
  write_png(options.folder + "/" + stem + "-sheet.png", sheet);
  const int width = pictures[0].film.width(), height = pictures[0].film.height();
  std::string script = formatted("set terminal pngcairo noenhanced size %d,%d font 'sans,9'\n%s", sheet.width(),
                                 sheet.height(), find_folder);
  script +=
      formatted("set margins 0,0,0,0\nunset border; unset tics; unset key\nset xrange [0:%d]; set yrange [%d:0]\n",
                sheet.width(), sheet.height());
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const auto [x, y] = place_on_sheet(static_cast<int>(i), columns, width, height);
    script += formatted("set label %s at %d,%d center tc rgb 'white' front\n", quoted(pictures[i].caption).c_str(),
                        x + width / 2, y + height + 13);
  }
  script += overlay +
            formatted("plot here.'%s-sheet.png' binary filetype=png origin=(0.5,0.5) dy=1 flipy with rgbimage\n",
                      stem.c_str());
  write_chart(options.folder + "/" + stem, script);
  return {stem + ".png", about};
}

StudyPicture write_map(const StudyOptions& options, const std::string& stem, const std::string& about,
                       const std::vector<double>& values, int across, const std::string& range,
                       const std::string& palette, const std::string& setting) {
  std::string script = "$map << EOD\n";
  for (std::size_t i = 0; i < values.size(); ++i)
    script += formatted("%.4g%s", values[i], (i + 1) % static_cast<std::size_t>(across) == 0 ? "\n" : " ");
  script += "EOD\nset yrange [*:*] reverse; set size ratio -1; unset tics; set cbtics; unset key\n";
  script += "set cbrange " + range + "; set palette " + palette + "\n" + setting + "plot $map matrix with image\n";
  return write_study_chart(options, stem, about, about, 760, 680, "1,1", script);
}

StudyPicture write_study_chart(const StudyOptions& options, const std::string& stem, const std::string& about,
                               const std::string& title, int width, int height, const char* layout,
                               const std::string& script) {
  write_chart(options.folder + "/" + stem, chart_head(title, width, height, layout) + script);
  return {stem + ".png", about};
}

}  // namespace fairlight

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <stdexcept>

#include <fairlight/render/atomic_file.h>
#include <fairlight/render/raster.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/report/artifacts.h>
#include <fairlight/validation/report/charts.h>
#include <fairlight/validation/report/report.h>

namespace fairlight {
namespace {

namespace fs = std::filesystem;

void make_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw std::runtime_error("cannot make the folder \"" + folder + "\" (" + error.message() + ")");
}

// The name "stem" if there is only one such file (n <= 1), else "stem_i".
std::string numbered(const std::string& stem, std::size_t i, std::size_t n) {
  return n > 1 ? stem + "_" + std::to_string(i) : stem;
}

void write_cells(const std::string& stem, const Evidence::Cells& cells) {
  std::string csv = "row,column,expected,counted,deviations,p\n";
  std::vector<Plane> planes{{"expected", {}}, {"counted", {}}, {"deviations", {}}, {"p", {}}};
  for (std::size_t i = 0; i < cells.counts.size(); ++i) {
    const CellResidue residue = cell_residue(cells, i);
    const auto columns = static_cast<std::size_t>(cells.columns);
    const auto counted = static_cast<double>(cells.counts[i]);
    csv += formatted("%zu,%zu,%.10g,%.0f,%.5g,%.5g\n", i / columns, i % columns, residue.expected, counted,
                     residue.deviations, residue.p);
    const std::array<double, 4> values{residue.expected, counted, residue.deviations, residue.p};
    for (std::size_t plane = 0; plane < 4; ++plane) {
      planes[plane].values.push_back(static_cast<float>(values[plane]));
    }
  }
  write_whole(stem + ".csv", csv);
  write_exr(stem + ".exr", cells.columns, cells.rows, planes);
}

void write_tiles(const std::string& path, const Evidence::Tiles& tiles) {
  const Plane plane{"bias", {tiles.biases.begin(), tiles.biases.end()}};
  write_exr(path, tiles.columns, static_cast<int>(tiles.biases.size()) / tiles.columns, {plane});
}

std::string courses_csv(const std::vector<Evidence::Course>& courses) {
  std::string csv =
      "channel,draws,mean,log_above_reference,log_below_reference,log_below_upper_margin,log_above_lower_margin\n";
  for (std::size_t c = 0; c < courses.size(); ++c) {
    for (const auto& [draws, mean, wealth] : courses[c].steps()) {
      csv += formatted("%zu,%llu,%.17g,%.6g,%.6g,%.6g,%.6g\n", c, static_cast<unsigned long long>(draws), mean,
                       wealth.above_reference, wealth.below_reference, wealth.below_upper_margin,
                       wealth.above_lower_margin);
    }
  }
  return csv;
}

// The channels with the most evidence against them, at most three, in order of their index.
std::vector<std::size_t> worst_channels(const std::vector<Evidence::Course>& courses) {
  std::vector<std::size_t> channels(courses.size());
  std::iota(channels.begin(), channels.end(), std::size_t{0});
  const auto against = [&](std::size_t c) {
    if (courses[c].steps().empty()) return 0.0;
    const Wealth& wealth = courses[c].steps().back().wealth;
    return std::max(wealth.above_reference, wealth.below_reference);
  };
  std::ranges::stable_sort(channels, [&](std::size_t a, std::size_t b) { return against(a) > against(b); });
  channels.resize(std::min<std::size_t>(channels.size(), 3));
  std::ranges::sort(channels);
  return channels;
}

}  // namespace

void check_folder(const std::string& folder) {
  std::error_code error;
  if (!fs::exists(folder, error)) return AtomicFile::check_writable(folder);
  if (!fs::is_directory(folder, error)) {
    throw std::runtime_error("cannot write into \"" + folder + "\" (it is no folder)");
  }
  AtomicFile::check_writable(folder + "/finding");
}

std::vector<std::string> write_artifacts(const std::string& folder, const Outcome& outcome,
                                         const RunOptions& run_options) {
  const std::string place = (fs::path(folder) / label(outcome, run_options)).string();
  make_folder(place);
  nlohmann::json json = outcome_json(outcome, run_options);
  json["statement"] = outcome.claim->statement;
  json["source"] = outcome.claim->source;
  write_json(place + "/finding.json", json);
  std::vector<std::string> pictures;
  const auto draw = [&](const std::string& stem, const std::string& script) {
    pictures.push_back(write_chart(place + "/" + stem, script));
  };
  const auto& laws = outcome.evidence.laws;
  const auto& means = outcome.evidence.means;
  const std::string title = label(outcome, run_options) + ": " + name(outcome.finding.verdict);
  for (std::size_t i = 0; i < laws.size(); ++i) {
    write_cells(place + "/" + numbered("cells", i, laws.size()), laws[i]);
    draw(numbered("p_map", i, laws.size()), p_map_script(title, laws[i]));
    draw(numbered("histogram", i, laws.size()), histogram_script(title, laws[i]));
  }
  if (const auto& tiles = outcome.evidence.tiles; tiles.columns > 1) {
    write_tiles(place + "/tiles.exr", tiles);
    draw("tiles", tile_map_script(title, tiles));
  }
  if (!means.empty()) write_whole(place + "/wealth.csv", courses_csv(means));
  for (std::size_t c : worst_channels(means)) {
    const std::string channel = means.size() > 1 ? ", channel " + std::to_string(c) : "";
    draw(numbered("wealth", c, means.size()), wealth_script(title + channel, means[c]));
  }
  return pictures;
}

std::string write_intervals(const std::string& folder, const std::vector<Outcome>& outcomes) {
  make_folder(folder);
  return write_chart(folder + "/intervals", intervals_script(outcomes));
}

}  // namespace fairlight

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include <fairlight/render/atomic_file.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/app/commands.h>
#include <fairlight/validation/app/options.h>
#include <fairlight/validation/app/progress.h>
#include <fairlight/validation/report/compare_report.h>

namespace fairlight {
namespace {

struct Options {
  std::vector<std::string> a, b;
  CompareOptions compare;
  double tile_margin = 0, samples = 0;
  CellOptions cells;
  std::string scale = "1", crop;
  std::string json, heat_map, png;
};

PixelWindow window_of(const std::string& text) {
  PixelWindow window;
  char rest = 0;
  const int fields =
      std::sscanf(text.c_str(), "%d,%d,%d,%d%c", &window.x0, &window.y0, &window.x1, &window.y1, &rest);
  if (fields != 4 || window.x0 >= window.x1 || window.y0 >= window.y1) {
    throw std::invalid_argument(
        "--crop \"" + text + "\" is no region (give x0,y0,x1,y1 with x0 < x1 and y0 < y1; x1 and y1 lie outside)");
  }
  return window;
}

void read_scale(const std::string& text, CompareOptions& options) {
  options.fit_scale = text == "fit";
  if (options.fit_scale) return;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), options.scale);
  if (problem != std::errc() || end != text.data() + text.size() || !(options.scale > 0) ||
      !std::isfinite(options.scale)) {
    throw std::invalid_argument("--scale \"" + text + "\" is neither a positive number nor fit");
  }
}

// Refuses an output that would overwrite an input or another output.
void check_outputs(const Options& options) {
  namespace fs = std::filesystem;
  std::vector<std::string> others = options.a;
  others.insert(others.end(), options.b.begin(), options.b.end());
  for (const std::string& output : {options.json, options.heat_map, options.png}) {
    if (output.empty()) continue;
    AtomicFile::check_writable(output);
    for (const std::string& other : others) {
      if (fs::weakly_canonical(fs::absolute(output)) == fs::weakly_canonical(fs::absolute(other)))
        throw std::invalid_argument("\"" + output + "\" names the same file twice (one would overwrite the other)");
    }
    others.push_back(output);
  }
}

std::string percent(double x) { return std::isfinite(x) ? formatted("%+.3g %%", 100 * x) : "open"; }

void print_row(const std::string& what, const CellComparison& cell) {
  const std::string interval = "[" + percent(cell.interval.lo) + ", " + percent(cell.interval.hi) + "]";
  std::printf("  %-10s %-10s in %-22s margin %.3g %%: %s\n", what.c_str(), percent(cell.difference).c_str(),
              interval.c_str(), 100 * cell.margin, name(cell.verdict));
}

void print_worst_tile(const ComparedCells& compared, const Comparison& comparison) {
  const CellComparison& tile = comparison.tiles[comparison.worst];
  const PixelWindow w = compared.cells.tile_window(comparison.worst / PictureCells::channels);
  const auto count = [&](Likeness verdict) {
    return std::ranges::count_if(comparison.tiles, [&](const CellComparison& t) { return t.verdict == verdict; });
  };
  std::printf("  %zu tiles, 3 channels each: %td same, %td different, %td undecided\n", compared.cells.tiles(),
              count(Likeness::same), count(Likeness::different), count(Likeness::undecided));
  std::printf("  largest evidence at x %d to %d, y %d to %d in %s: A is %.3g %% %s, in [%s, %s], p = %.1e\n", w.x0,
              w.x1 - 1, w.y0, w.y1 - 1, compared.channels[comparison.worst % PictureCells::channels].c_str(),
              100 * std::abs(tile.difference), tile.difference < 0 ? "darker" : "brighter",
              percent(tile.interval.lo).c_str(), percent(tile.interval.hi).c_str(), tile.p_value);
}

void print_advice(const ComparedCells& compared, const Comparison& comparison, const CompareOptions& options) {
  if (comparison.verdict != Likeness::undecided) return;
  if (std::isfinite(comparison.shown_margin)) {
    std::printf("these pictures show a margin of %.3g %%, and %.3g %% for tiles and border\n",
                100 * comparison.shown_margin,
                100 * comparison.shown_margin * options.tile_margin / options.margin);
  }
  const double renders = renders_for_margin(compared, comparison);
  if (renders > 0 && compared.a.means.size() > 1 && compared.b.means.size() > 1)
    std::printf("if the images are equal, %.3g %% takes about %.0f such renders a side\n", 100 * options.margin,
                renders);
  else if (renders > 0)
    std::printf("if the images are equal, %.3g %% takes about %.3g times the samples\n", 100 * options.margin,
                std::max(1.0, comparison.renders_for_margin));
  else
    std::printf("no number of such renders shows %.3g %%: the files round too much, or are black\n",
                100 * options.margin);
}

void print(const ComparedCells& compared, const Comparison& comparison, const CompareOptions& options) {
  const char* what = comparison.verdict == Likeness::same ? "both estimate the same image to within the margins"
                     : comparison.verdict == Likeness::different ? "they estimate different images"
                                                                 : "neither likeness nor difference is shown";
  std::printf("%s: %s (A has %zu renders, B %zu; false alarms %.0e; asymptotic)\n", name(comparison.verdict), what,
              compared.a.means.size(), compared.b.means.size(), options.alpha);
  if (options.fit_scale)
    std::printf("  A is %.5g +- %.2g times B; differences are to B times this\n", comparison.scale,
                comparison.scale_error);
  for (std::size_t c = 0; c < PictureCells::channels; ++c) print_row(compared.channels[c], comparison.whole[c]);
  for (std::size_t c = 0; c < PictureCells::channels; ++c)
    print_row("balanced " + compared.channels[c], comparison.balanced[c]);
  for (std::size_t c = 0; c < PictureCells::channels; ++c)
    print_row("border " + compared.channels[c], comparison.border[c]);
  print_worst_tile(compared, comparison);
  print_advice(compared, comparison, options);
}

int status_of(Likeness verdict) { return verdict == Likeness::same ? 0 : verdict == Likeness::different ? 1 : 3; }

int compare(Options options) {
  check_outputs(options);
  read_scale(options.scale, options.compare);
  options.compare.tile_margin =
      options.tile_margin > 0 ? options.tile_margin : std::min(10 * options.compare.margin, 0.49);
  if (!options.crop.empty()) options.cells.crop = window_of(options.crop);
  options.cells.by_pictures = options.cells.by_pictures || options.compare.fit_scale;
  if (options.samples > 0) options.cells.samples = options.samples;
  const ComparedCells compared = read_cells(options.a, options.b, options.cells, progress_bar("compare"));
  const Comparison comparison = compare_cells(compared.cells, compared.a, compared.b, options.compare);
  if (!options.json.empty()) write_json(options.json, comparison_json(compared, comparison, options.compare));
  if (!options.heat_map.empty()) write_heat_map(options.heat_map, compared, comparison);
  if (!options.png.empty()) write_heat_map_png(options.png, compared, comparison);
  print(compared, comparison, options.compare);
  return status_of(comparison.verdict);
}

void add_statistics(CLI::App& app, Options& options) {
  begin_group(app, "Statistics");
  add_number(app, "--margin", options.compare.margin, {.low = 0, .high = 0.5},
             "Show that the mean of each channel differs by less than this part of it.")
      ->capture_default_str();
  add_number(app, "--tile-margin", options.tile_margin, {.low = 0, .high = 0.5},
             "Show that tiles and border differ by less than this part of their mean, or of the balanced mean if "
             "that is larger. Default: 10 times --margin, at most 0.49.");
  add_number(app, "--alpha", options.compare.alpha, {.low = 0, .high = 0.5},
             "Call equal images different with this probability, over all channels and tiles.")
      ->capture_default_str();
  add_count(app, "--tile", options.cells.tile, 1, 65536,
            "Compare tiles of about this many pixels a side. Default: an eighth of the longer side.");
  app.add_flag("--by-pictures", options.cells.by_pictures,
               "Take the noise from the spread of the pictures, also where all have error layers of fairlight.");
  add_text(app, "--scale", options.scale, "K|fit",
           "Expect A to be K times B, as of another exposure; with fit, estimate K from the pictures.")
      ->capture_default_str();
}

void add_pictures(CLI::App& app, Options& options) {
  begin_group(app, "Pictures");
  app.add_option("pictures", options.a, "Compare these renders: one set of independent pictures, A.")
      ->required()
      ->type_name("A.exr");
  app.add_option("--with", options.b, "Compare with these renders: the other set, B.")
      ->required()
      ->expected(1, -1)
      ->type_name("B.exr");
  add_text(app, "--crop", options.crop, "x0,y0,x1,y1",
           "Compare only columns x0 to x1 - 1 and rows y0 to y1 - 1 of the data window.");
  add_text(app, "--layer", options.cells.layer, "NAME",
           "Compare this layer or part, such as ViewLayer.Combined, where a file has several.");
  add_number(app, "--samples", options.samples, {.low = 1},
             "A single file has this many samples a pixel, if it has variances and does not say so.");
  add_number(app, "--filter-radius", options.cells.filter_radius, {.low = 0, .high = 32},
             "The samples of a single file reach pixels up to this distance. Above 0.5 pixels, pixels depend on "
             "each other.")
      ->capture_default_str();
}

void add_files(CLI::App& app, Options& options) {
  begin_group(app, "Output");
  add_text(app, "--json", options.json, "F.json", "Write the comparison to this JSON file.");
  add_text(app, "--heatmap", options.heat_map, "F.exr",
           "Write the difference of each tile, its interval and its p-value to this OpenEXR file.");
  add_text(app, "--png", options.png, "F.png",
           "Write a map of the differences to this PNG file: red where A is brighter, blue where it is darker.");
}

}  // namespace

void add_compare_command(CLI::App& program, Command& command) {
  auto* app = program.add_subcommand(
      "compare", "Compare two sets of pictures, of any renderers: whether they estimate the same image.");
  auto options = std::make_shared<Options>();
  add_pictures(*app, *options);
  add_statistics(*app, *options);
  add_files(*app, *options);
  add_examples(*app, {"fairlight compare a1.exr a2.exr a3.exr --with b1.exr b2.exr b3.exr --margin 0.01",
                      "fairlight compare old.exr --with new.exr --heatmap map.exr --png map.png",
                      "fairlight compare a*.exr --with b*.exr --scale fit --crop 0,0,64,64"});
  app->callback([options, &command] { command = [options] { return compare(*options); }; });
}

}  // namespace fairlight

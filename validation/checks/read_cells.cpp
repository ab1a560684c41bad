#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <stdexcept>

#include <fairlight/render/settings.h>
#include <fairlight/stats/hash.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/checks/read_cells.h>
#include <fairlight/validation/checks/side_sums.h>

namespace fairlight {
namespace {

constexpr double values_in_memory = 1 << 25;

std::string in_quotes(const std::string& path) { return "\"" + path + "\""; }

std::string words(const PixelWindow& w) { return formatted("%d,%d,%d,%d", w.x0, w.y0, w.x1, w.y1); }

// One file of a side, as it is read.
struct Input {
  PictureFile file;
  std::uint64_t hash = 0;
  std::uint64_t nans = 0, infinities = 0;
  std::string first_bad;

  void look_at(const PixelBlock& block, const PixelWindow& window) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::vector<float>& plane = block.colour[c];
      hash = hash_of({reinterpret_cast<const char*>(plane.data()), plane.size() * sizeof(float)}, hash);
      for (std::size_t i = 0; i < plane.size(); ++i) {
        if (!std::isfinite(plane[i])) count_bad(plane[i], c, static_cast<int>(i), window);
      }
    }
  }

  void count_bad(float value, std::size_t channel, int i, const PixelWindow& window) {
    if (nans + infinities == 0) {
      first_bad = formatted("%s of pixel (%d, %d)", file.channels()[channel].c_str(),
                            window.x0 + i % window.width(), window.y0 + i / window.width());
    }
    ++(std::isnan(value) ? nans : infinities);
  }

  void check_finite() const {
    if (nans + infinities == 0) return;
    const char* advice = file.half() && nans == 0
                             ? "half floats end at 65504: save floats, or leave them out by --crop"
                             : "leave them out by --crop, or render again";
    throw std::runtime_error(in_quotes(file.path()) +
                             formatted(" holds %llu NaN and %llu infinite values, the first in %s (%s)",
                                       static_cast<unsigned long long>(nans),
                                       static_cast<unsigned long long>(infinities), first_bad.c_str(), advice));
  }
};

// How many samples of a file of fairlight depend on each other; 0 for files of others.
double points_of(const PictureFile& file) {
  const auto settings = nlohmann::json::parse(file.attribute("fairlight.settings"), nullptr, false);
  return settings.is_object() ? settings.value("points", 0.0) : 0;
}

class SideReader {
 public:
  SideReader(const std::vector<std::string>& paths, const CellOptions& options, bool with_errors) {
    for (const std::string& path : paths)
      inputs_.push_back({PictureFile(path, options.layer, with_errors), 0, 0, 0, ""});
    const PictureFile& first = inputs_[0].file;
    noise_.half = std::ranges::any_of(inputs_, [](const Input& input) { return input.file.half(); });
    // Pixels of fairlight are independent of each other, so their errors say more than a few
    // pictures do, unless sets of points leave few draws a pixel.
    const bool independent =
        std::ranges::all_of(inputs_, [](const Input& input) { return points_of(input.file) == 1; });
    if (inputs_.size() == 1 || (independent && !options.by_pictures)) noise_.error_layer = first.error_layer();
    noise_.samples_per_draw = std::max(1.0, points_of(first));
    noise_.samples = options.samples ? options.samples : first.samples_per_pixel();
    noise_.filter_radius = options.filter_radius;
    if (inputs_.size() == 1) check_error_layer();
  }

  const std::vector<Input>& inputs() const { return inputs_; }

  void start(const PictureCells& cells) { sums_.emplace(cells, inputs_.size(), noise_); }

  void read_rows(const PixelWindow& band) {
    std::vector<PixelBlock> blocks;
    for (Input& input : inputs_) {
      blocks.push_back(input.file.read(band));
      input.look_at(blocks.back(), band);
    }
    const bool finite =
        std::ranges::none_of(inputs_, [](const Input& input) { return input.nans + input.infinities > 0; });
    if (!finite) return;  // the rest is only read to count what is not
    try {
      sums_->add(band, blocks);
    } catch (const std::domain_error& problem) {
      throw std::runtime_error(in_quotes(inputs_[0].file.path()) + " has " + problem.what());
    }
  }

  SideOfCells finish() {
    for (const Input& input : inputs_) input.check_finite();
    return std::move(*sums_).finish();
  }

 private:
  void check_error_layer() const {
    const PictureFile& file = inputs_[0].file;
    if (file.error_layer() == ErrorLayer::none) {
      throw std::runtime_error(in_quotes(file.path()) +
                               " is alone on its side and has no error layer (give several independent renders)");
    }
    if (file.error_layer() != ErrorLayer::standard_error && !noise_.samples) {
      throw std::runtime_error(in_quotes(file.path()) +
                               " does not say how many samples a pixel has (give their number by --samples)");
    }
  }

  std::vector<Input> inputs_;
  PixelNoise noise_;
  std::optional<SideSums> sums_;
};

using Inputs = std::vector<const Input*>;

Inputs all_inputs(const SideReader& a, const SideReader& b) {
  Inputs all;
  for (const SideReader* side : {&a, &b})
    for (const Input& input : side->inputs()) all.push_back(&input);
  return all;
}

void check_paths(const Inputs& inputs) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (std::filesystem::equivalent(inputs[i]->file.path(), inputs[j]->file.path()))
        throw std::runtime_error(in_quotes(inputs[i]->file.path()) +
                                 " is given twice (renders must be independent)");
    }
  }
}

// Files of fairlight say which samples they hold.
void check_samples(const Inputs& inputs) {
  SampleLedger all;
  for (const Input* input : inputs) {
    const std::string samples = input->file.attribute("fairlight.seed");
    if (samples.empty()) continue;
    try {
      all.merge(SampleLedger::from_json(nlohmann::json::parse(samples)));
    } catch (const std::exception&) {
      throw std::runtime_error(
          in_quotes(input->file.path()) +
          " has the seed and samples of another file (renders must be independent: give each its own seed)");
    }
  }
}

void check_pixels(const Inputs& inputs) {
  std::map<std::uint64_t, std::string> seen;
  for (const Input* input : inputs) {
    const auto [other, is_new] = seen.emplace(input->hash, input->file.path());
    if (!is_new) {
      throw std::runtime_error(in_quotes(input->file.path()) + " and " + in_quotes(other->second) +
                               " hold the same pixels (renders must be independent: give each its own seed)");
    }
  }
}

void check_alike(const Inputs& inputs) {
  const PictureFile& first = inputs.front()->file;
  for (const Input* input : inputs) {
    const std::string both = in_quotes(first.path()) + " and " + in_quotes(input->file.path());
    if (input->file.channel_letters() != first.channel_letters()) {
      throw std::runtime_error(both + " have different channels, " + first.channel_letters() + " and " +
                               input->file.channel_letters() + " (convert one of them)");
    }
    for (std::size_t i = 0; i < 8; ++i) {
      if (std::abs(input->file.chromaticities()[i] - first.chromaticities()[i]) > 1e-4)
        throw std::runtime_error(both + " have different primaries or white points (convert one of them)");
    }
  }
}

PixelWindow region_of(const Inputs& inputs, const std::optional<PixelWindow>& crop) {
  const PictureFile& first = inputs.front()->file;
  for (const Input* input : inputs) {
    const PixelWindow window = input->file.data_window();
    if (crop && !window.contains(*crop)) {
      throw std::runtime_error("--crop " + words(*crop) + " is not inside the pixels of " +
                               in_quotes(input->file.path()) + ", " + words(window) + " (give a smaller region)");
    }
    if (!crop && window != first.data_window()) {
      throw std::runtime_error(in_quotes(first.path()) + " and " + in_quotes(input->file.path()) +
                               " have different pixels, " + words(first.data_window()) + " and " + words(window) +
                               " (give a region that both have by --crop x0,y0,x1,y1)");
    }
  }
  return crop.value_or(first.data_window());
}

}  // namespace

ComparedCells read_cells(const std::vector<std::string>& a, const std::vector<std::string>& b,
                         const CellOptions& options, const Progress& progress) {
  const bool with_errors = a.size() == 1 || b.size() == 1;  // on both sides, for equal channels
  SideReader side_a(a, options, with_errors), side_b(b, options, with_errors);
  const Inputs inputs = all_inputs(side_a, side_b);
  check_paths(inputs);
  check_alike(inputs);
  check_samples(inputs);
  ComparedCells compared{PictureCells(region_of(inputs, options.crop), options.tile), {}, {}, {}};
  const PixelWindow& region = compared.cells.region();
  side_a.start(compared.cells);
  side_b.start(compared.cells);
  const double values_in_row = 7.0 * region.width() * static_cast<double>(inputs.size());
  const int rows = std::clamp(static_cast<int>(values_in_memory / values_in_row), 1, 64);
  for (int y = region.y0; y < region.y1; y += rows) {
    const PixelWindow band{region.x0, y, region.x1, std::min(y + rows, region.y1)};
    side_a.read_rows(band);
    side_b.read_rows(band);
    if (progress) progress(static_cast<double>(band.y1 - region.y0) / region.height());
  }
  compared.a = side_a.finish();
  compared.b = side_b.finish();
  check_pixels(inputs);
  const std::string letters = inputs.front()->file.channel_letters();
  for (std::size_t c = 0; c < 3; ++c) compared.channels[c] = std::string(1, letters[c]);
  return compared;
}

}  // namespace fairlight

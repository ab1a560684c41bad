#include <algorithm>
#include <array>
#include <cmath>

#include <fairlight/render/raster.h>
#include <fairlight/validation/report/compare_report.h>

namespace fairlight {
namespace {

constexpr long long most_pixels = 1 << 24;
constexpr std::size_t channels = PictureCells::channels;

// Which tile each pixel of a map shows.
struct Map {
  int width, height;
  std::vector<std::size_t> tiles;

  explicit Map(const PictureCells& cells) : width(cells.region().width()), height(cells.region().height()) {
    const bool full = static_cast<long long>(width) * height <= most_pixels;
    if (!full) {
      width = cells.columns();
      height = cells.rows();
    }
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x)
        tiles.push_back(full ? cells.tile_at(x, y)
                             : static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                   static_cast<std::size_t>(x));
    }
  }
};

nlohmann::json number(double x) { return std::isfinite(x) ? nlohmann::json(x) : nlohmann::json(); }

nlohmann::json json_of(const std::string& channel, const CellComparison& cell) {
  return {{"name", channel},
          {"verdict", name(cell.verdict)},
          {"difference", cell.difference},
          {"interval", {number(cell.interval.lo), number(cell.interval.hi)}},
          {"p", cell.p_value}};
}

nlohmann::json json_of(const ComparedCells& compared, const std::array<CellComparison, 3>& cells) {
  nlohmann::json all = nlohmann::json::array();
  for (std::size_t c = 0; c < channels; ++c) all.push_back(json_of(compared.channels[c], cells[c]));
  return all;
}

nlohmann::json json_of_tiles(const ComparedCells& compared, const Comparison& comparison) {
  const auto count = [&](Likeness verdict) {
    return std::ranges::count_if(comparison.tiles,
                                 [&](const CellComparison& tile) { return tile.verdict == verdict; });
  };
  return {{"columns", compared.cells.columns()},
          {"rows", compared.cells.rows()},
          {"same", count(Likeness::same)},
          {"different", count(Likeness::different)},
          {"undecided", count(Likeness::undecided)}};
}

nlohmann::json json_of_worst(const ComparedCells& compared, const Comparison& comparison) {
  const PixelWindow w = compared.cells.tile_window(comparison.worst / channels);
  nlohmann::json json = json_of(compared.channels[comparison.worst % channels], comparison.tiles[comparison.worst]);
  json.update({{"x0", w.x0}, {"y0", w.y0}, {"x1", w.x1}, {"y1", w.y1}});
  return json;
}

}  // namespace

void write_heat_map(const std::string& path, const ComparedCells& compared, const Comparison& comparison) {
  const Map map(compared.cells);
  std::vector<Plane> planes;
  const auto add = [&](const std::string& layer, const auto& value) {
    for (std::size_t c = 0; c < channels; ++c) {
      planes.push_back({layer + compared.channels[c], {}});
      for (const std::size_t tile : map.tiles)
        planes.back().values.push_back(static_cast<float>(value(comparison.tiles[channels * tile + c])));
    }
  };
  add("", [](const CellComparison& tile) { return tile.difference; });
  add("low.", [](const CellComparison& tile) { return tile.interval.lo; });
  add("high.", [](const CellComparison& tile) { return tile.interval.hi; });
  add("p.", [](const CellComparison& tile) { return tile.p_value; });
  write_exr(path, map.width, map.height, planes);
}

void write_heat_map_png(const std::string& path, const ComparedCells& compared, const Comparison& comparison) {
  const Map map(compared.cells);
  std::vector<std::uint8_t> bytes;
  for (const std::size_t tile : map.tiles) {
    const auto first = comparison.tiles.begin() + static_cast<std::ptrdiff_t>(channels * tile);
    const CellComparison& most = *std::max_element(first, first + channels, [](const auto& a, const auto& b) {
      return std::abs(a.difference) < std::abs(b.difference);
    });
    const double part = std::min(1.0, std::abs(most.difference) / most.margin);
    const auto pale = static_cast<std::uint8_t>(std::lround(255 * (1 - part)));
    const std::uint8_t full = 255;
    const bool brighter = most.difference > 0;
    bytes.insert(bytes.end(), {brighter ? full : pale, pale, brighter ? pale : full});
  }
  write_png(path, map.width, map.height, bytes);
}

double renders_for_margin(const ComparedCells& compared, const Comparison& comparison) {
  if (!std::isfinite(comparison.renders_for_margin)) return 0;
  const double n = static_cast<double>(std::max(compared.a.means.size(), compared.b.means.size()));
  return std::ceil(n * comparison.renders_for_margin);
}

nlohmann::json comparison_json(const ComparedCells& compared, const Comparison& comparison,
                               const CompareOptions& options) {
  return {{"verdict", name(comparison.verdict)},
          {"guarantee", name(Guarantee::asymptotic)},
          {"margin", options.margin},
          {"tile_margin", options.tile_margin},
          {"alpha", options.alpha},
          {"scale", comparison.scale},
          {"scale_error", comparison.scale_error},
          {"channels", json_of(compared, comparison.whole)},
          {"balanced", json_of(compared, comparison.balanced)},
          {"border", json_of(compared, comparison.border)},
          {"tiles", json_of_tiles(compared, comparison)},
          {"worst_tile", json_of_worst(compared, comparison)},
          {"shown_margin", number(comparison.shown_margin)},
          {"renders", {compared.a.means.size(), compared.b.means.size()}},
          {"renders_for_margin", renders_for_margin(compared, comparison)}};
}

}  // namespace fairlight

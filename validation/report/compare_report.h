#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include <fairlight/validation/checks/compare_cells.h>
#include <fairlight/validation/checks/read_cells.h>

namespace fairlight {

/// Writes where two sets of pictures differ as an OpenEXR file of the region's size: for each
/// channel the tile's relative difference, the ends of its interval and its p-value. Regions of
/// more than 2^24 pixels get a pixel a tile. Throws std::runtime_error.
void write_heat_map(const std::string& path, const ComparedCells& compared, const Comparison& comparison);

/// The same as a PNG: red where A is brighter, blue where it is darker, white where they are equal.
/// Shows the channel that differs most; the colour is full at the margin of tiles.
void write_heat_map_png(const std::string& path, const ComparedCells& compared, const Comparison& comparison);

/// A comparison as JSON: {verdict, guarantee, margin, tile_margin, alpha, scale, channels: [{name,
/// verdict, difference, interval, p}], balanced, border, tiles: {columns, rows, same, different,
/// undecided}, worst_tile: {x0, y0, x1, y1, name, ...}, shown_margin, renders, renders_for_margin}.
/// An open end of an interval is null.
nlohmann::json comparison_json(const ComparedCells& compared, const Comparison& comparison,
                               const CompareOptions& options);

/// About how many renders a side would show `same`; 0 if no number would.
double renders_for_margin(const ComparedCells& compared, const Comparison& comparison);

}  // namespace fairlight

#pragma once

#include <string>

#include <fairlight/stats/evidence.h>
#include <fairlight/validation/report/canvas.h>

namespace fairlight {

/// The count of a cell compared with its probability.
struct CellResidue {
  double expected;
  double deviations;  ///< (count - expected) in standard deviations
  double p;           ///< two-sided p-value by the binomial law, as in the test
};
CellResidue cell_residue(const Evidence::Cells& cells, std::size_t cell);

/// Draws the counts along both axes of the cells as bars, and the expected counts as a line. Below,
/// it draws the relative differences with two standard deviations. Neighbours share a bar if there
/// are many cells.
Canvas histogram_chart(const std::string& title, const Evidence::Cells& cells);

/// Draws the p-value of each cell at its place: red for too many draws, blue for too few, in full
/// colour for p <= 1e-8.
Canvas p_map_chart(const std::string& title, const Evidence::Cells& cells);

/// Draws the bias of each tile at its place: red for too bright, blue for too dark, in full colour
/// from twice the margin on.
Canvas tile_map_chart(const std::string& title, const Evidence::Tiles& tiles);

/// Draws the wealth of the four processes, which starts at 1, against the number of draws, with the
/// levels that decide.
Canvas wealth_chart(const std::string& title, const Evidence::Course& course);

}  // namespace fairlight

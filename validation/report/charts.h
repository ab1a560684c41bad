#pragma once

#include <string>

#include <fairlight/stats/evidence.h>
#include <fairlight/validation/report/canvas.h>

namespace fairlight {

/// What the counts of a cell say against its probability.
struct CellResidue {
  double expected;
  double deviations;  ///< standard deviations that the count is above (or below) what is expected
  double p;           ///< two-sided p-value, by the binomial law: that of the test
};
CellResidue cell_residue(const Evidence::Cells& cells, std::size_t cell);

/// The draws along both axes of the cells, as bars, against what is expected, a line; beneath them, by how much they differ, with two
/// standard deviations. Where cells are very many, neighbours share a bar.
Canvas histogram_chart(const std::string& title, const Evidence::Cells& cells);

/// The p-values of the cells, in their places: red where there are too many draws, blue where there are too few, deep for p below 1e-8.
Canvas p_map_chart(const std::string& title, const Evidence::Cells& cells);

/// The biases of tiles, in their places: red where they are too bright, blue where they are too dark, deep at twice the margin.
Canvas tile_map_chart(const std::string& title, const Evidence::Tiles& tiles);

/// What the four processes have made of 1, against draws, with the levels that decide.
Canvas wealth_chart(const std::string& title, const Evidence::Course& course);

}  // namespace fairlight

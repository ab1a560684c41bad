#pragma once

#include <string>
#include <vector>

#include <fairlight/validation/run/run_claims.h>

namespace fairlight {

/// The count of a cell compared with its probability.
struct CellResidue {
  double expected;
  double deviations;  ///< (count - expected) in standard deviations
  double p;           ///< two-sided p-value by the binomial law, as in the test
};
CellResidue cell_residue(const Evidence::Cells& cells, std::size_t cell);

/// Each of these functions returns a chart as a gnuplot script that contains its data and prints a
/// PNG. See docs/validation.md for what the charts show.
std::string histogram_script(const std::string& title, const Evidence::Cells& cells);
std::string p_map_script(const std::string& title, const Evidence::Cells& cells);
std::string tile_map_script(const std::string& title, const Evidence::Tiles& tiles);
std::string wealth_script(const std::string& title, const Evidence::Course& course);
std::string intervals_script(const std::vector<Outcome>& outcomes);

/// How every chart begins: a terminal of that size in pixels, a title above panels in this layout
/// ("rows,columns"), and names of colours. The title may hold any letters.
std::string chart_head(const std::string& title, int width, int height = 700, const char* layout = "1,1");

/// Throws std::runtime_error unless gnuplot can be run and has the terminal pngcairo.
void check_gnuplot();

/// Writes the script as `stem`.gp and the PNG that gnuplot makes of it as `stem`.png, each whole or
/// not at all. Returns the path of the PNG. Throws std::runtime_error with what gnuplot says.
std::string write_chart(const std::string& stem, const std::string& script);

}  // namespace fairlight

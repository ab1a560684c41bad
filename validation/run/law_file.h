#pragma once

#include <istream>
#include <string>
#include <vector>

namespace fairlight {

/// A law over intervals that touch: interval i is [edges[i], edges[i+1]), the last with its end.
struct IntervalLaw {
  std::vector<double> edges;
  std::vector<double> probabilities;
};

/// Reads a law from text, whose rows are as NumberStream reads them. Rows of three numbers are
/// cells: low, high, probability. Rows of two numbers tabulate a density: x, density, linear between
/// rows; each interval between rows is a cell. Throws BadInput, with the row, unless the rows ascend
/// and touch, no value is negative or not finite, there are 2 to 2^20 cells, and the probabilities
/// sum to 1 within 1e-6.
IntervalLaw read_law(std::istream& in, const std::string& name);

}  // namespace fairlight

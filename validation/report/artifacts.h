#pragma once

#include <string>
#include <vector>

#include <fairlight/validation/run/run_claims.h>

namespace fairlight {

/// Throws std::runtime_error unless files can be written to the folder. It may be missing if its
/// parent exists. Leaves nothing behind.
void check_folder(const std::string& folder);

/// Writes the evidence of one claim as files in `folder`/`label`, which it creates if needed:
///  * finding.json, the claim and its finding;
///  * for a law, cells.csv and cells.exr (counts, expected counts and p-values), histogram.png and
///    p_map.png;
///  * for a mean, wealth.csv (the course of the test in every channel) and wealth.png (the three
///    channels with the most evidence against them).
/// Each chart has its gnuplot script beside it, as NAME.gp. Writes each file whole or not at all,
/// and returns the paths of the pictures. Throws std::runtime_error.
std::vector<std::string> write_artifacts(const std::string& folder, const Outcome& outcome,
                                         const RunOptions& run_options);

/// Draws all intervals in units of their margins as `folder`/intervals.png, and returns this path.
/// Throws std::runtime_error.
std::string write_intervals(const std::string& folder, const std::vector<Outcome>& outcomes);

}  // namespace fairlight

#pragma once

#include <string>
#include <vector>

#include <fairlight/validation/run/run_claims.h>

namespace fairlight {

/// Throws std::runtime_error unless files can be put into the folder, which may still have to be made where there is one to hold it.
/// Leaves nothing behind.
void check_folder(const std::string& folder);

/// What was seen of one claim, as files in `folder`/`label`, which is made where it is not there; each file is written whole or not at all:
///  * finding.json, the claim and what was found;
///  * of a law, cells.csv and cells.exr: counts, what was expected, and p-values; and as pictures histogram.png and p_map.png;
///  * of a mean, wealth.csv: the course of the test in every channel; and as pictures wealth.png, of at most three channels, those with
///    the most evidence against them.
/// Returns the pictures' paths. Throws std::runtime_error.
std::vector<std::string> write_artifacts(const std::string& folder, const Outcome& outcome,
                                         const RunOptions& run_options);

/// All intervals in units of their margins, as the picture `folder`/intervals.png, whose path it returns. Throws std::runtime_error.
std::string write_intervals(const std::string& folder, const std::vector<Outcome>& outcomes);

}  // namespace fairlight

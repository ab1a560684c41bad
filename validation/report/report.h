#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <fairlight/validation/run/run_claims.h>

namespace fairlight {

/// The command that runs a claim again, draw for draw.
std::string replay(const Claim& claim, const RunOptions& run_options);

/// The command that makes a whole run again, of these claims with spaces between them, or of all for no name.
std::string replay_run(const std::string& claims, const RunOptions& run_options);

/// The name of an outcome's claim, with its instruction set where the run has several.
std::string label(const Outcome& outcome, const RunOptions& run_options);

/// The instruction sets that outcomes are about, in words: "sse2, avx2".
std::string instruction_list(const std::vector<Outcome>& outcomes);

/// The outcomes with the worst verdict first, else in their order.
std::vector<Outcome> worst_first(std::vector<Outcome> outcomes);

/// "a", "a and b", "a, b and c"; of more names than `most` those first and a count: "a, b and 7
/// more".
std::string list_of(const std::vector<std::string>& names, std::size_t most);

/// An end of an interval in three digits, or "open" where it is infinite: see Finding.
std::string end_text(double end);

/// Which rows a table has.
enum class Rows {
  grouped,  ///< a row a failure, with why and how to replay it; and where the others are many, a row for those of one first name
  all,      ///< a row a claim
};

/// A table of claims, the worst verdict first. On a terminal, verdicts are coloured.
void print_outcomes(std::FILE* out, const std::vector<Outcome>& outcomes, const RunOptions& run_options,
                    Rows rows = Rows::grouped);

/// One outcome as JSON, and all: {version, seed, budget, seconds, verdict, claims: [...]}. JSON has
/// no infinity: an end of an interval that is open is null, as is a margin that a ledger does not
/// certify.
nlohmann::json outcome_json(const Outcome& outcome, const RunOptions& run_options);
nlohmann::json outcomes_json(const std::vector<Outcome>& outcomes, const RunOptions& run_options, double seconds);

}  // namespace fairlight

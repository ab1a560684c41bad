#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <fairlight/validation/conformance.h>

namespace fairlight {

/// The command that runs a claim again, or several with spaces between them, draw for draw; all for no name.
std::string replay(const std::string& claims, const Conformance& conformance);

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
void print_outcomes(std::FILE* out, const std::vector<Outcome>& outcomes, const Conformance& conformance,
                    Rows rows = Rows::grouped);

/// One outcome as JSON, and all: {version, seed, budget, seconds, verdict, claims: [...]}. JSON has
/// no infinity: an end of an interval that is open is null, as is a margin that a ledger does not
/// certify.
nlohmann::json outcome_json(const Outcome& outcome, const Conformance& conformance);
nlohmann::json outcomes_json(const std::vector<Outcome>& outcomes, const Conformance& conformance, double seconds);

}  // namespace fairlight

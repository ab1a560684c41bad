#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <fairlight/validation/run/components.h>

namespace fairlight {

/// The command that runs a claim again, draw for draw.
std::string replay(const Claim& claim, const RunOptions& run_options);

/// The command that repeats a run of these claims, separated by spaces; an empty string means all
/// claims.
std::string replay_run(const std::string& claims, const RunOptions& run_options);

/// The name of the claim of an outcome. It includes the instruction set if the run has several.
std::string label(const Outcome& outcome, const RunOptions& run_options);

/// The instruction sets of the outcomes, as text: "sse2, avx2".
std::string instruction_list(const std::vector<Outcome>& outcomes);

/// The place of a verdict in a table: `biased` first, `certified` last.
int rank(Verdict verdict);

/// The outcomes, sorted stably with the worst verdict first.
std::vector<Outcome> worst_first(std::vector<Outcome> outcomes);

/// Lists names: "a", "a and b", "a, b and c". Beyond `most` names it gives a count: "a, b and 7
/// more".
std::string list_of(const std::vector<std::string>& names, std::size_t most);

/// An end of an interval with three digits, or "open" if it is infinite: see Finding.
std::string end_text(double end);

/// The rows of a table.
enum class Rows {
  grouped,  ///< a row for each failure, with its reason and replay; many others share rows by first name
  all,      ///< a row for each claim
};

/// Prints a table of claims, the worst verdict first. On a terminal, verdicts are coloured.
void print_outcomes(std::FILE* out, const std::vector<Outcome>& outcomes, const RunOptions& run_options,
                    Rows rows = Rows::grouped);

/// Prints a row for each component, the worst verdict first, below a heading that says what is
/// tested; nothing for none.
void print_components(std::FILE* out, const std::vector<ComponentOutcome>& components,
                      const RunOptions& run_options);

/// The common bias that a component has or excludes, in words.
std::string common_bias_text(const ComponentOutcome& component);

/// One outcome as JSON, one component, and a whole run: {version, seed, budget, seconds, verdict,
/// claims: [...], components: [...]}. JSON has no infinity: an open end of an interval is null, and
/// so is a margin where none is certified.
nlohmann::json outcome_json(const Outcome& outcome, const RunOptions& run_options);
nlohmann::json component_json(const ComponentOutcome& component);
nlohmann::json outcomes_json(const std::vector<Outcome>& outcomes, const std::vector<ComponentOutcome>& components,
                             const RunOptions& run_options, double seconds);

}  // namespace fairlight

#include <algorithm>
#include <cmath>

#include <fairlight/stats/seed.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/report/report.h>
#include <fairlight/validation/run/replay_token.h>
#include <fairlight/version.h>

namespace fairlight {
namespace {

// The shortest decimal text that reads back as this number.
std::string digits(double value) { return nlohmann::json(value).dump(); }

std::string verify_command(const std::string& claims, const Manifest::Terms& terms,
                           const std::string& instructions) {
  std::string command =
      "fairlight verify" + (claims.empty() ? "" : " " + claims) + " --seed " + replay_token(terms.seed);
  const Manifest::Terms usual{.seed = 0};
  if (terms.margin != usual.margin) command += " --margin " + digits(terms.margin);
  if (terms.budget != usual.budget) command += " --budget " + digits(terms.budget);
  if (!instructions.empty()) command += " --instructions " + instructions;
  return command;
}

}  // namespace

std::string replay(const Claim& claim, const RunOptions& run_options) {
  Manifest::Terms terms = run_options.terms;
  terms.budget /= static_cast<double>(run_options.instructions.size());
  return verify_command(claim.name, terms, claim.instructions);
}

std::string replay_run(const std::string& claims, const RunOptions& run_options) {
  const auto& sets = run_options.instructions;
  return verify_command(claims, run_options.terms, sets.size() == 1 ? sets.front() : "all");
}

std::string label(const Outcome& outcome, const RunOptions& run_options) {
  const Claim& claim = *outcome.claim;
  return run_options.instructions.size() == 1 ? claim.name : claim.name + " [" + claim.instructions + "]";
}

std::string instruction_list(const std::vector<Outcome>& outcomes) {
  std::vector<std::string> sets;
  for (const Outcome& outcome : outcomes) {
    if (std::ranges::find(sets, outcome.claim->instructions) == sets.end())
      sets.push_back(outcome.claim->instructions);
  }
  std::string list;
  for (const std::string& set : sets) list += (list.empty() ? "" : ", ") + set;
  return list;
}

int rank(Verdict verdict) { return verdict == Verdict::biased ? 0 : verdict == Verdict::undecided ? 1 : 2; }

std::vector<Outcome> worst_first(std::vector<Outcome> outcomes) {
  std::stable_sort(outcomes.begin(), outcomes.end(), [](const Outcome& a, const Outcome& b) {
    return rank(a.finding.verdict) < rank(b.finding.verdict);
  });
  return outcomes;
}

std::string list_of(const std::vector<std::string>& names, std::size_t most) {
  const std::size_t named = std::min(names.size(), most);
  std::string list;
  for (std::size_t i = 0; i < named; ++i) {
    const bool last = i + 1 == names.size();
    list += (i == 0 ? "" : last ? " and " : ", ") + names[i];
  }
  return named < names.size() ? list + " and " + std::to_string(names.size() - named) + " more" : list;
}

std::string end_text(double end) { return std::isinf(end) ? "open" : formatted("%+.2e", end); }

std::string common_bias_text(const ComponentOutcome& component) {
  if (component.verdict == Verdict::biased)
    return component.upward ? "found: the means are too high" : "found: the means are too low";
  if (std::isinf(component.margin)) return "not known yet";
  return formatted("below %.1e", component.margin);
}

nlohmann::json outcome_json(const Outcome& outcome, const RunOptions& run_options) {
  const Finding& finding = outcome.finding;
  nlohmann::json json = {{"name", outcome.claim->name},
                         {"kind", outcome.claim->kind},
                         {"verdict", name(finding.verdict)},
                         {"guarantee", name(finding.guarantee)},
                         {"margin", finding.margin},
                         {"bias", finding.bias},
                         {"interval", {finding.interval.lo, finding.interval.hi}},
                         {"samples", finding.draws},
                         {"seconds", outcome.seconds},
                         {"real", outcome.claim->real},
                         {"instructions", outcome.claim->instructions},
                         {"rounding", finding.rounding},
                         {"note", finding.note},
                         {"out_of_time", outcome.out_of_time},
                         {"replay", replay(*outcome.claim, run_options)}};
  if (outcome.ledger) json["ledger"] = {{"runs", outcome.ledger->runs}, {"margin", outcome.ledger->margin}};
  return json;
}

nlohmann::json component_json(const ComponentOutcome& component) {
  nlohmann::json json = {{"name", component.name},
                         {"instructions", component.instructions},
                         {"claims", component.claims},
                         {"verdict", name(component.verdict)},
                         {"common_bias", common_bias_text(component)},
                         {"margin", component.margin}};
  if (component.ledger) json["ledger"] = {{"runs", component.ledger->runs}, {"margin", component.ledger->margin}};
  return json;
}

nlohmann::json outcomes_json(const std::vector<Outcome>& outcomes, const std::vector<ComponentOutcome>& components,
                             const RunOptions& run_options, double seconds) {
  nlohmann::json claims = nlohmann::json::array(), together = nlohmann::json::array();
  for (const Outcome& outcome : outcomes) claims.push_back(outcome_json(outcome, run_options));
  for (const ComponentOutcome& component : components) together.push_back(component_json(component));
  return {{"version", version},
          {"seed", seed_text(run_options.terms.seed)},
          {"budget", run_options.terms.budget},
          {"seconds", seconds},
          {"verdict", name(overall(outcomes, components))},
          {"claims", claims},
          {"components", together}};
}

}  // namespace fairlight

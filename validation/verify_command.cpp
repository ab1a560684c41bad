#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numeric>
#include <optional>

#include <fairlight/render/parallel.h>
#include <fairlight/render/progress.h>
#include <fairlight/render/whole_file.h>
#include <fairlight/stats/seed.h>
#include <fairlight/validation/commands.h>
#include <fairlight/validation/conformance.h>
#include <fairlight/validation/ledger/ledger_run.h>
#include <fairlight/validation/provenance/replay_token.h>
#include <fairlight/validation/provenance/since.h>
#include <fairlight/validation/registry.h>
#include <fairlight/validation/report/artifacts.h>
#include <fairlight/validation/report/markdown.h>
#include <fairlight/validation/report/report.h>

namespace fairlight {
namespace {

struct VerifyOptions {
  std::vector<std::string> claims;
  bool list = false;
  bool all = false;
  std::string seed, json, artifacts, report, ledger, since, instructions;
  Conformance conformance{{.seed = 0}, hardware_threads()};
};

int list(const std::vector<const Claim*>& claims) {
  for (const Claim* claim : claims) {
    std::printf("%-34s %-10s %s\n", claim->name.c_str(), claim->kind.c_str(), claim->statement.c_str());
  }
  return 0;
}

int exit_status(Verdict verdict) { return verdict == Verdict::certified ? 0 : verdict == Verdict::biased ? 1 : 3; }

bool certified(const Outcome& outcome) { return outcome.finding.verdict == Verdict::certified; }

// What the table does not say of itself: what a finer margin costs, as draws go with its inverse square, and how much rests on limits.
void print_depth(const std::vector<Outcome>& outcomes, const Conformance& conformance, double seconds) {
  const auto resting_on = [&](Guarantee guarantee) {
    return std::count_if(outcomes.begin(), outcomes.end(),
                         [=](const Outcome& outcome) { return outcome.finding.guarantee == guarantee; });
  };
  std::printf("guarantees: %td exact, %td asymptotic (each says why), %td deterministic\n",
              resting_on(Guarantee::exact), resting_on(Guarantee::asymptotic),
              resting_on(Guarantee::deterministic));
  std::printf("deeper: --margin %.0e takes at most 100 times as long, here %.0f min\n",
              conformance.terms.margin / 10, std::ceil(100 * seconds / 60));
}

// The names of those that failed, a few of them.
std::string names_of_failures(const std::vector<Outcome>& outcomes, const Conformance& conformance) {
  constexpr int most = 5;
  std::string names;
  int failures = 0;
  for (const Outcome& outcome : worst_first(outcomes)) {
    if (!failed(outcome) || ++failures > most) continue;
    names += (names.empty() ? "" : ", ") + label(outcome, conformance);
  }
  return failures > most ? names + ", ..." : names;
}

void print_verdict(const std::vector<Outcome>& outcomes, const Conformance& conformance, double seconds) {
  const Verdict verdict = overall(outcomes);
  const auto passed = std::ranges::count_if(outcomes, certified);
  const auto failures = std::ranges::count_if(outcomes, failed);
  const auto late = static_cast<std::ptrdiff_t>(outcomes.size()) - passed - failures;
  if (verdict == Verdict::certified) {
    std::printf("certified: all of %zu claims hold to within their margins", outcomes.size());
  } else if (failures > 0) {
    std::printf("%s: %td of %zu claims failed", name(verdict), failures, outcomes.size());
  } else {
    std::printf("undecided: %td of %zu claims hold to within their margins", passed, outcomes.size());
  }
  if (late > 0) std::printf(", %td had no verdict when the time was up", late);
  std::printf(" (packets of %s, %.1f s, seed %s, false alarms %.0e a run, miss rate %.0e a claim)\n",
              instruction_list(outcomes).c_str(), seconds, seed_text(conformance.terms.seed).c_str(),
              conformance.terms.budget, conformance.terms.beta);
  if (failures > 0) std::printf("failed: %s\n", names_of_failures(outcomes, conformance).c_str());
  if (verdict == Verdict::certified) print_depth(outcomes, conformance, seconds);
}

// A report without pictures would not show what failed: it has a folder for them beside it.
std::string artifact_folder(const VerifyOptions& options) {
  if (!options.artifacts.empty() || options.report.empty()) return options.artifacts;
  return std::filesystem::path(options.report).replace_extension().string() + "_artifacts";
}

// Throws std::invalid_argument where two options name the same file.
void require_different(const std::vector<std::pair<std::string, std::string>>& options) {
  namespace fs = std::filesystem;
  std::map<fs::path, std::string> taken;
  for (const auto& [option, file] : options) {
    if (file.empty()) continue;
    const auto [other, is_new] = taken.emplace(fs::weakly_canonical(fs::absolute(file)), option);
    if (!is_new)
      throw std::invalid_argument(other->second + " and " + option + " name the same file, \"" + file +
                                  "\" (one would overwrite the other)");
  }
}

void check_outputs(const VerifyOptions& options) {
  if (!options.json.empty()) WholeFile::check_writable(options.json);
  if (!options.report.empty()) WholeFile::check_writable(options.report);
  if (!artifact_folder(options).empty()) check_folder(artifact_folder(options));
  require_different({{"--json", options.json}, {"--report", options.report}, {"--ledger", options.ledger}});
}

// For each claim that failed, and each that was asked for by its whole name.
std::map<std::string, std::vector<std::string>> write_all_artifacts(const VerifyOptions& options,
                                                                    const std::vector<Outcome>& outcomes,
                                                                    const Conformance& conformance) {
  std::map<std::string, std::vector<std::string>> pictures;
  for (const Outcome& outcome : outcomes) {
    const bool named = std::ranges::find(options.claims, outcome.claim->name) != options.claims.end();
    if (!named && !failed(outcome)) continue;
    pictures[label(outcome, conformance)] = write_artifacts(artifact_folder(options), outcome, conformance);
  }
  return pictures;
}

void write_outputs(const VerifyOptions& options, const std::vector<Outcome>& outcomes,
                   const Conformance& conformance, double seconds) {
  if (!options.json.empty()) write_json(options.json, outcomes_json(outcomes, conformance, seconds));
  const std::string folder = artifact_folder(options);
  if (folder.empty()) return;
  const auto pictures = write_all_artifacts(options, outcomes, conformance);
  const std::string overview = write_intervals(folder, outcomes);
  if (!options.report.empty()) {
    const std::string claims = std::accumulate(options.claims.begin(), options.claims.end(), std::string(),
                                               [](const std::string& all, const std::string& claim) {
                                                 return all + (all.empty() ? "" : " ") + "'" + claim + "'";
                                               });
    write_whole(options.report,
                markdown({outcomes, conformance, seconds, replay_run(claims, conformance), overview, pictures},
                         options.report));
  }
}

// The widest instruction set for no name, each that runs here for "all".
std::vector<std::string> chosen_instructions(const std::string& name) {
  if (name == "all") return claimed_instructions();
  return {registry(name).front().instructions};
}

int verify(const VerifyOptions& options) {
  Conformance conformance = options.conformance;
  conformance.instructions = chosen_instructions(options.instructions);
  std::vector<const Claim*> claims;
  for (const std::string& set : conformance.instructions) {
    const std::vector<const Claim*> selected = select_claims(options.claims, set);
    claims.insert(claims.end(), selected.begin(), selected.end());
    if (options.list) break;
  }
  if (!options.since.empty()) claims = claims_since(options.since, claims, this_build());
  if (options.list) return list(claims);
  if (claims.empty()) return 0;
  conformance.terms.seed = options.seed.empty() ? fresh_seed() : parse_replay_token(options.seed);
  check_outputs(options);
  std::optional<LedgerRun> ledger;
  if (!options.ledger.empty()) ledger.emplace(options.ledger, claims, this_build());
  conformance.evidence = ledger.has_value() || !artifact_folder(options).empty();
  const auto start = std::chrono::steady_clock::now();
  std::vector<Outcome> outcomes = run_claims(claims, conformance, progress_bar("verify"));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (ledger) ledger->add(outcomes, conformance);
  write_outputs(options, outcomes, conformance, seconds);
  print_outcomes(stdout, outcomes, conformance, options.all ? Rows::all : Rows::grouped);
  print_verdict(outcomes, conformance, seconds);
  if (ledger) ledger->print(stdout);
  return exit_status(overall(outcomes));
}

// An empty value is what an unset shell variable makes; it is not the same as no option.
std::string not_empty(const std::string& value) { return value.empty() ? "the value is empty" : ""; }

}  // namespace

void add_verify_command(CLI::App& program, Command& command) {
  auto* app = program.add_subcommand("verify", "Certify the estimators: each claim certified, biased or undecided");
  auto options = std::make_shared<VerifyOptions>();
  auto& terms = options->conformance.terms;
  app->add_option("claims", options->claims,
                  "Which claims: names, their first parts, or patterns; all if none given")
      ->type_name("CLAIM");
  app->add_flag("--list", options->list, "List the claims, and run nothing");
  app->add_flag("--all", options->all, "A row for every claim, where else those that hold are grouped");
  app->add_option("--margin", terms.margin, "The relative bias to exclude")->capture_default_str();
  app->add_option("--budget", terms.budget, "The probability of a false alarm in a whole run")
      ->capture_default_str();
  app->add_option("--seed", options->seed,
                  "Replays a run: the token that it printed, or a seed of 1 to 16 hexadecimal digits");
  app->add_option(
         "--instructions", options->instructions,
         "Certify the packets of this instruction set, or of all that this machine has; default: the widest, "
         "which render uses")
      ->type_name("SET");
  app->add_option("--seconds", options->conformance.seconds,
                  "The time to take: first what looks wrong, then what is soon done; the rest is undecided");
  app->add_option("--json", options->json, "The outcomes, as JSON")->type_name("F.json");
  app->add_option("--artifacts", options->artifacts,
                  "A folder for what was seen of each claim that failed, or is named in full: pictures and tables")
      ->type_name("DIR");
  app->add_option("--report", options->report,
                  "The outcomes, as a page with pictures, which --artifacts or F_artifacts holds")
      ->type_name("F.md");
  app->add_option("--ledger", options->ledger, "A file in which the evidence of runs adds up, to finer margins")
      ->check(not_empty, "")
      ->type_name("F");
  app->add_option("--since", options->since, "Only claims whose sources differ from this git revision")
      ->check(not_empty, "")
      ->type_name("REV");
  app->add_option("--threads", options->conformance.threads, "Threads")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app->callback([options, &command] { command = [options] { return verify(*options); }; });
}

}  // namespace fairlight

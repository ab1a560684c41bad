#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numeric>
#include <optional>

#include <fairlight/render/atomic_file.h>
#include <fairlight/render/parallel.h>
#include <fairlight/stats/seed.h>
#include <fairlight/validation/app/commands.h>
#include <fairlight/validation/app/options.h>
#include <fairlight/validation/app/progress.h>
#include <fairlight/validation/report/artifacts.h>
#include <fairlight/validation/report/charts.h>
#include <fairlight/validation/report/markdown.h>
#include <fairlight/validation/report/report.h>
#include <fairlight/validation/run/ledger_run.h>
#include <fairlight/validation/run/registry.h>
#include <fairlight/validation/run/replay_token.h>
#include <fairlight/validation/run/run_claims.h>
#include <fairlight/validation/run/since.h>

namespace fairlight {
namespace {

struct VerifyOptions {
  std::vector<std::string> claims;
  bool list = false;
  bool all = false;
  std::string seed, json, artifacts, report, ledger, since, instructions;
  RunOptions run_options{{.seed = 0}, hardware_threads()};
};

int list(const std::vector<const Claim*>& claims) {
  for (const Claim* claim : claims) {
    std::printf("%-34s %-10s %s (validation/claims/%s)\n", claim->name.c_str(), claim->kind.c_str(),
                claim->statement.c_str(), claim->file.c_str());
  }
  return 0;
}

int exit_status(Verdict verdict) { return verdict == Verdict::certified ? 0 : verdict == Verdict::biased ? 1 : 3; }

bool certified(const Outcome& outcome) { return outcome.finding.verdict == Verdict::certified; }

// Prints what the table leaves out: how many claims rest on limit theorems, and the cost of a finer
// margin, as the number of draws grows with the inverse square of the margin.
void print_depth(const std::vector<Outcome>& outcomes, const RunOptions& run_options, double seconds) {
  const auto resting_on = [&](Guarantee guarantee) {
    return std::count_if(outcomes.begin(), outcomes.end(),
                         [=](const Outcome& outcome) { return outcome.finding.guarantee == guarantee; });
  };
  std::printf(
      "guarantees: %td exact, %td exact given their tails, %td asymptotic (each says why), %td deterministic\n",
      resting_on(Guarantee::exact), resting_on(Guarantee::exact_given_tail), resting_on(Guarantee::asymptotic),
      resting_on(Guarantee::deterministic));
  std::printf("deeper: --margin %.0e takes at most 100 times as long, here %.0f min\n",
              run_options.terms.margin / 10, std::ceil(100 * seconds / 60));
}

std::string names_of_failures(const std::vector<Outcome>& outcomes, const RunOptions& run_options) {
  std::vector<std::string> names;
  for (const Outcome& outcome : worst_first(outcomes)) {
    if (failed(outcome)) names.push_back(label(outcome, run_options));
  }
  return list_of(names, 5);
}

// The names of the components that are biased.
std::vector<std::string> biased_of(const std::vector<ComponentOutcome>& components) {
  std::vector<std::string> names;
  for (const ComponentOutcome& component : components) {
    if (component.verdict == Verdict::biased) names.push_back(component.name);
  }
  return names;
}

void print_verdict(const std::vector<Outcome>& outcomes, const std::vector<ComponentOutcome>& components,
                   const RunOptions& run_options, double seconds) {
  const Verdict verdict = overall(outcomes, components);
  const auto passed = std::ranges::count_if(outcomes, certified);
  const auto failures = std::ranges::count_if(outcomes, failed);
  const auto late = static_cast<std::ptrdiff_t>(outcomes.size()) - passed - failures;
  if (verdict == Verdict::certified) {
    std::printf("certified: all of %zu claims hold to within their margins", outcomes.size());
  } else if (failures > 0) {
    std::printf("%s: %td of %zu claims failed", name(verdict), failures, outcomes.size());
  } else if (verdict == Verdict::biased) {
    std::printf("biased: no claim alone, but the claims of a component together");
  } else {
    std::printf("undecided: %td of %zu claims hold to within their margins", passed, outcomes.size());
  }
  if (late > 0) std::printf(", %td had no verdict when the time was up", late);
  std::printf(" (packets of %s, %.1f s, seed %s, false alarms %.0e a run, miss rate %.0e a claim)\n",
              instruction_list(outcomes).c_str(), seconds, seed_text(run_options.terms.seed).c_str(),
              run_options.terms.budget, run_options.terms.beta);
  if (failures > 0) std::printf("failed: %s\n", names_of_failures(outcomes, run_options).c_str());
  if (const auto biased = biased_of(components); !biased.empty())
    std::printf("components biased: %s\n", list_of(biased, 5).c_str());
  if (verdict == Verdict::certified) print_depth(outcomes, run_options, seconds);
}

// The folder of the pictures. A report needs them to show what failed, so by default it gets a
// folder beside it.
std::string artifact_folder(const VerifyOptions& options) {
  if (!options.artifacts.empty() || options.report.empty()) return options.artifacts;
  return std::filesystem::path(options.report).replace_extension().string() + "_artifacts";
}

// Throws std::invalid_argument if two options name the same file.
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
  if (!options.json.empty()) AtomicFile::check_writable(options.json);
  if (!options.report.empty()) AtomicFile::check_writable(options.report);
  if (!artifact_folder(options).empty()) {
    check_folder(artifact_folder(options));
    check_gnuplot();
  }
  require_different({{"--json", options.json}, {"--report", options.report}, {"--ledger", options.ledger}});
}

// Whoever chooses the numbers of a run may choose what it shows, and a ledger adds up what fresh numbers
// show.
void check_ledger_options(const VerifyOptions& options) {
  if (options.ledger.empty() || options.seed.empty()) return;
  throw std::invalid_argument(
      "--seed and --ledger exclude each other (numbers that were chosen, or seen before, are no new evidence; "
      "leave one out)");
}

// Writes the artifacts of each claim that failed, and of each that the user gave by its whole name.
std::map<std::string, std::vector<std::string>> write_all_artifacts(const VerifyOptions& options,
                                                                    const std::vector<Outcome>& outcomes,
                                                                    const RunOptions& run_options) {
  std::map<std::string, std::vector<std::string>> pictures;
  for (const Outcome& outcome : outcomes) {
    const bool named = std::ranges::find(options.claims, outcome.claim->name) != options.claims.end();
    if (!named && !failed(outcome)) continue;
    pictures[label(outcome, run_options)] = write_artifacts(artifact_folder(options), outcome, run_options);
  }
  return pictures;
}

void write_outputs(const VerifyOptions& options, const std::vector<Outcome>& outcomes,
                   const std::vector<ComponentOutcome>& components, const RunOptions& run_options, double seconds) {
  if (!options.json.empty()) write_json(options.json, outcomes_json(outcomes, components, run_options, seconds));
  const std::string folder = artifact_folder(options);
  if (folder.empty()) return;
  const auto pictures = write_all_artifacts(options, outcomes, run_options);
  const std::string overview = write_intervals(folder, outcomes);
  if (!options.report.empty()) {
    const std::string claims = std::accumulate(options.claims.begin(), options.claims.end(), std::string(),
                                               [](const std::string& all, const std::string& claim) {
                                                 return all + (all.empty() ? "" : " ") + "'" + claim + "'";
                                               });
    write_whole(options.report, markdown({outcomes, components, run_options, seconds,
                                          replay_run(claims, run_options), overview, pictures},
                                         options.report));
  }
}

// The instruction sets to run: the widest for an empty name, all that this machine has for "all".
std::vector<std::string> chosen_instructions(const std::string& name) {
  if (name == "all") return claimed_instructions();
  return {registry(name).front().instructions};
}

int verify(const VerifyOptions& options) {
  RunOptions run_options = options.run_options;
  run_options.instructions = chosen_instructions(options.instructions);
  std::vector<const Claim*> claims;
  for (const std::string& set : run_options.instructions) {
    const std::vector<const Claim*> selected = select_claims(options.claims, set);
    claims.insert(claims.end(), selected.begin(), selected.end());
    if (options.list) break;
  }
  if (!options.since.empty()) claims = claims_since(options.since, claims, this_build());
  if (options.list) return list(claims);
  if (claims.empty()) return 0;
  run_options.terms.seed = options.seed.empty() ? fresh_seed() : parse_replay_token(options.seed);
  check_outputs(options);
  check_ledger_options(options);
  std::optional<LedgerRun> ledger;
  if (!options.ledger.empty()) ledger.emplace(options.ledger, claims, this_build());
  run_options.evidence = ledger.has_value() || !artifact_folder(options).empty();
  const auto start = std::chrono::steady_clock::now();
  std::vector<Outcome> outcomes = run_claims(claims, run_options, progress_bar("verify"));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::vector<ComponentOutcome> components = component_outcomes(outcomes, run_options);
  if (ledger) ledger->add(outcomes, components, run_options);
  write_outputs(options, outcomes, components, run_options, seconds);
  print_outcomes(stdout, outcomes, run_options, options.all ? Rows::all : Rows::grouped);
  print_components(stdout, components, run_options);
  print_verdict(outcomes, components, run_options, seconds);
  if (ledger) ledger->print(stdout);
  return exit_status(overall(outcomes, components));
}

void add_selection(CLI::App& app, VerifyOptions& options) {
  begin_group(app, "What to certify");
  app.add_option("claims", options.claims,
                 "Certify these claims: names such as hemisphere.cosine.law, the first parts of names such as "
                 "hemisphere, or patterns such as '*.law'. All claims if none is given.")
      ->type_name("CLAIM");
  app.add_flag("--list", options.list, "List the claims with what they say, and run nothing.");
  add_text(app, "--since", options.since, "REV",
           "Certify only claims whose sources differ from this git revision, for example HEAD.");
  add_text(
      app, "--instructions", options.instructions, "SET|all",
      "Certify the packets of this instruction set, for example sse2, or of all that this machine has. The widest "
      "if not given, which render uses.");
}

void add_terms(CLI::App& app, VerifyOptions& options) {
  Manifest::Terms& terms = options.run_options.terms;
  begin_group(app, "How strictly");
  add_number(app, "--margin", terms.margin, {.low = 0, .high = 1},
             "Exclude biases of this part of the reference and more, for example 1e-4. The number of draws goes "
             "with its inverse square.")
      ->capture_default_str();
  add_number(app, "--budget", terms.budget, {.low = 0, .high = 1},
             "Let a run of all claims raise a false alarm with this probability.")
      ->capture_default_str();
  add_text(app, "--seed", options.seed, "TOKEN",
           "Replay a run: give the token that it printed, or a seed of 1 to 16 hexadecimal digits. Fresh if not "
           "given.");
}

void add_outputs(CLI::App& app, VerifyOptions& options) {
  begin_group(app, "What to write");
  app.add_flag("--all", options.all,
               "Print a row for every claim. Without it, when more than 40 hold, they share a row for each first "
               "name.");
  add_text(app, "--json", options.json, "F.json", "Write the outcomes to this JSON file.");
  add_text(app, "--artifacts", options.artifacts, "DIR",
           "Write what was seen of each claim that failed, or is named in full, to this folder: pictures and "
           "tables.");
  add_text(app, "--report", options.report, "F.md",
           "Write a page with pictures to this file; the pictures go to the folder of --artifacts, or "
           "F_artifacts.");
  add_text(app, "--ledger", options.ledger, "F",
           "Add what this run shows to this file, and certify the finer margins that all its runs show together.");
}

void add_running(CLI::App& app, VerifyOptions& options) {
  begin_group(app, "Running");
  add_number(app, "--seconds", options.run_options.seconds, {.low = 0},
             "Stop after this many seconds: first what looks wrong runs, then what is soon done; the rest is "
             "undecided. No limit if not given.");
  app.add_flag("--fail-fast", options.run_options.fail_fast,
               "Stop at the first claim that fails; what has no verdict then is undecided.");
  add_threads(app, options.run_options.threads);
}

}  // namespace

void add_verify_command(CLI::App& program, Command& command) {
  auto* app = program.add_subcommand("verify", "Certify estimators: each claim is certified, biased or undecided.");
  auto options = std::make_shared<VerifyOptions>();
  add_selection(*app, *options);
  add_terms(*app, *options);
  add_outputs(*app, *options);
  add_running(*app, *options);
  add_examples(*app, {"fairlight verify hemisphere --margin 1e-4", "fairlight verify --since HEAD --seconds 60",
                      "fairlight verify --report verify.md --ledger evidence.txt"});
  app->callback([options, &command] { command = [options] { return verify(*options); }; });
}

}  // namespace fairlight

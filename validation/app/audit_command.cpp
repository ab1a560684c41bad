#include <algorithm>
#include <cstdio>
#include <memory>
#include <set>

#include <fairlight/render/atomic_file.h>
#include <fairlight/render/parallel.h>
#include <fairlight/stats/seed.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/app/commands.h>
#include <fairlight/validation/app/options.h>
#include <fairlight/validation/app/progress.h>
#include <fairlight/validation/audit/fault_audit.h>
#include <fairlight/validation/audit/judges_audit.h>
#include <fairlight/validation/report/report.h>

namespace fairlight {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Share, count, of)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(JudgeOutcome, name, alarms, alarms_planned, suites, kills, kills_planned, faults,
                                   missed)

namespace {

// The options of the audits that run the claims.
struct AuditOptions {
  std::string seed{}, json{};
  int seeds;
  RunOptions run_options{{.seed = 0}, hardware_threads()};

  // Checks that the output can be written. The run options get the first seed.
  RunOptions begin() const {
    if (!json.empty()) AtomicFile::check_writable(json);
    RunOptions begun = run_options;
    begun.terms.seed = seed.empty() ? fresh_seed() : parse_seed(seed);
    return begun;
  }
};

nlohmann::json faults_json(const std::vector<FaultOutcome>& outcomes) {
  nlohmann::json faults = nlohmann::json::array();
  for (const FaultOutcome& o : outcomes) {
    faults.push_back({{"name", o.fault->name},
                      {"class", o.fault->kind},
                      {"source", o.fault->source},
                      {"claim", o.claim->name},
                      {"kind", o.claim->kind},
                      {"effect", o.effect},
                      {"margin", o.margin},
                      {"draws", o.draws},
                      {"seconds", o.seconds},
                      {"caught", o.caught},
                      {"seeds", o.seeds},
                      {"note", o.note}});
  }
  nlohmann::json alive = nlohmann::json::array();
  for (const Survivor& survivor : survivors(outcomes)) {
    alive.push_back({{"name", survivor.fault->name}, {"reason", survivor.reason}, {"expected", survivor.expected}});
  }
  return {{"faults", faults}, {"survivors", alive}};
}

// Prints a row for every fault in every claim that should catch it.
void print(const std::vector<FaultOutcome>& outcomes) {
  std::printf("%-22s %-30s %-40s %-12s %10s %12s %8s %8s\n", "class", "fault", "claim", "kind", "effect", "draws",
              "seconds", "caught");
  for (const FaultOutcome& o : outcomes) {
    std::printf("%-22s %-30s %-40s %-12s %+10.2e %12llu %8.4f %4d/%d\n", o.fault->kind.c_str(),
                o.fault->name.c_str(), o.claim->name.c_str(), o.claim->kind.c_str(), o.effect,
                static_cast<unsigned long long>(o.draws), o.seconds, o.caught, o.seeds);
    if (o.draws == 0) std::printf("    %s\n", o.note.c_str());  // it ended before the first draw
  }
}

int faults(const AuditOptions& options) {
  const RunOptions run_options = options.begin();
  const auto outcomes = audit_faults(run_options, options.seeds, progress_bar("audit faults"));
  if (!options.json.empty()) write_json(options.json, faults_json(outcomes));
  print(outcomes);
  std::set<std::string> classes;
  for (const Fault& fault : fault_catalogue()) classes.insert(fault.kind);
  const auto alive = survivors(outcomes);
  std::printf("%zu of %zu faults, of %zu classes, caught with every seed (first seed %s)\n",
              fault_catalogue().size() - alive.size(), fault_catalogue().size(), classes.size(),
              seed_text(run_options.terms.seed).c_str());
  for (const Survivor& survivor : alive) {
    std::printf("%s: %s\n    %s\n", survivor.expected ? "survivor, as expected" : "SURVIVOR",
                survivor.fault->name.c_str(), survivor.reason.c_str());
  }
  return std::ranges::all_of(alive, &Survivor::expected) ? 0 : 1;
}

std::string in_words(const Share& share) {
  return formatted("%.1f %% (%d/%d)", 100.0 * share.count / share.of, share.count, share.of);
}

void print(const JudgesOutcome& outcome) {
  std::printf("%-36s %18s %18s %18s %20s %20s %18s\n", "", "right code failed", "of planned size",
              "suites, planned", "wrong code failed", "of planned size", "faults, planned");
  for (const JudgeOutcome& o : outcome.judges) {
    std::printf("%-36s %18s %18s %18s %20s %20s %18s\n", o.name.c_str(), in_words(o.alarms).c_str(),
                in_words(o.alarms_planned).c_str(), in_words(o.suites).c_str(), in_words(o.kills).c_str(),
                in_words(o.kills_planned).c_str(), in_words(o.faults).c_str());
  }
}

nlohmann::json judges_json(const JudgesOutcome& outcome, const RunOptions& run_options) {
  return {{"judges", outcome.judges},
          {"rows", outcome.rows},
          {"cells", outcome.cells},
          {"planned_draws", outcome.planned_draws},
          {"margin", run_options.terms.margin},
          {"seed", seed_text(run_options.terms.seed)}};
}

int judges(const AuditOptions& options) {
  const RunOptions run_options = options.begin();
  const JudgesOutcome outcome = audit_judges(run_options, options.seeds, progress_bar("audit judges"));
  if (!options.json.empty()) write_json(options.json, judges_json(outcome, run_options));
  print(outcome);
  std::printf(
      "%d claims, %d times with a fault in them, %d seeds each; planned size: %.2e draws in all (first seed %s)\n",
      outcome.rows, outcome.cells, options.seeds, outcome.planned_draws, seed_text(run_options.terms.seed).c_str());
  const JudgeOutcome& fairlight = outcome.judges.front();
  return fairlight.alarms.count == 0 && fairlight.faults.count == fairlight.faults.of ? 0 : 1;
}

// Adds an audit with these options, and --margin where `margin_help` says for what.
void add_audit(CLI::App& sub, Command& command, int (*run)(const AuditOptions&), AuditOptions defaults,
               const std::string& seeds_help, const std::string& margin_help, const std::string& json_help) {
  auto options = std::make_shared<AuditOptions>(std::move(defaults));
  begin_group(sub, "Runs");
  add_count(sub, "--seeds", options->seeds, 1, 100000, seeds_help)->capture_default_str();
  if (!margin_help.empty())
    add_number(sub, "--margin", options->run_options.terms.margin, {.low = 0, .high = 1}, margin_help)
        ->capture_default_str();
  add_text(sub, "--seed", options->seed, "HEX",
           "Start at this seed, 1 to 16 hexadecimal digits. Fresh if not given.");
  begin_group(sub, "Files");
  add_text(sub, "--json", options->json, "F.json", json_help);
  add_threads(sub, options->run_options.threads);
  sub.callback([options, &command, run] { command = [options, run] { return run(*options); }; });
}

}  // namespace

void add_audit_command(CLI::App& program, Command& command) {
  auto* app = program.add_subcommand("audit", "Test the tests: wrong estimators must fail, right ones must not.");
  auto* sub = app->add_subcommand(
      "faults", "Run wrong estimators through the claims: each must be found biased with every seed.");
  add_audit(*sub, command, faults, {.seeds = 300},
            "Run each fault with this many seeds; 300 take some eleven minutes on two cores.", "",
            "Write the table of faults and claims to this JSON file.");
  add_examples(*sub, {"fairlight audit faults --seeds 10 --json faults.json"});
  add_tester_commands(*app, command);
  add_mutate_command(*app, command);
  add_domains_command(*app, command);
  sub = app->add_subcommand(
      "judges", "Judge the same draws by the tests of other projects: count false alarms and missed faults.");
  add_audit(*sub, command, judges, {.seeds = 10},
            "Run each claim and fault with this many seeds; each takes two minutes on one core.",
            "Plan the size of the tests so that fairlight excludes biases of this part of the reference.",
            "Write the table of judges to this JSON file.");
  add_examples(*sub, {"fairlight audit judges --seeds 2 --margin 0.01 --json judges.json"});
  add_examples(*app, {"fairlight audit faults --seeds 10", "fairlight audit calibration --short"});
}

}  // namespace fairlight

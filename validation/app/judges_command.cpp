#include <cstdio>
#include <memory>

#include <fairlight/render/atomic_file.h>
#include <fairlight/render/parallel.h>
#include <fairlight/stats/seed.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/app/commands.h>
#include <fairlight/validation/app/options.h>
#include <fairlight/validation/app/progress.h>
#include <fairlight/validation/audit/judges_audit.h>
#include <fairlight/validation/report/report.h>

namespace fairlight {
namespace {

struct JudgesOptions {
  std::string seed, json;
  int seeds = 10;
  RunOptions run_options{{.seed = 0}, hardware_threads()};
};

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

nlohmann::json share_json(const Share& share) { return {{"count", share.count}, {"of", share.of}}; }

nlohmann::json json_of(const JudgesOutcome& outcome, const RunOptions& run_options) {
  nlohmann::json judges = nlohmann::json::array();
  for (const JudgeOutcome& o : outcome.judges) {
    judges.push_back({{"name", o.name},
                      {"alarms", share_json(o.alarms)},
                      {"alarms_planned", share_json(o.alarms_planned)},
                      {"suites", share_json(o.suites)},
                      {"kills", share_json(o.kills)},
                      {"kills_planned", share_json(o.kills_planned)},
                      {"faults", share_json(o.faults)},
                      {"missed", o.missed}});
  }
  return {{"judges", judges},
          {"rows", outcome.rows},
          {"cells", outcome.cells},
          {"planned_draws", outcome.planned_draws},
          {"margin", run_options.terms.margin},
          {"seed", seed_text(run_options.terms.seed)}};
}

int run(const JudgesOptions& options) {
  if (!options.json.empty()) AtomicFile::check_writable(options.json);
  RunOptions run_options = options.run_options;
  run_options.terms.seed = options.seed.empty() ? fresh_seed() : parse_seed(options.seed);
  const JudgesOutcome outcome = audit_judges(run_options, options.seeds, progress_bar("audit judges"));
  if (!options.json.empty()) write_json(options.json, json_of(outcome, run_options));
  print(outcome);
  std::printf(
      "%d claims, %d times with a fault in them, %d seeds each; planned size: %.2e draws in all (first seed %s)\n",
      outcome.rows, outcome.cells, options.seeds, outcome.planned_draws, seed_text(run_options.terms.seed).c_str());
  const JudgeOutcome& fairlight = outcome.judges.front();
  return fairlight.alarms.count == 0 && fairlight.faults.count == fairlight.faults.of ? 0 : 1;
}

}  // namespace

void add_judges_command(CLI::App& audit, Command& command) {
  auto* sub = audit.add_subcommand(
      "judges", "Judge the same draws by the tests of other projects: count false alarms and missed faults.");
  auto options = std::make_shared<JudgesOptions>();
  RunOptions& run_options = options->run_options;
  begin_group(*sub, "Runs");
  add_count(*sub, "--seeds", options->seeds, 1, 100000,
            "Run each claim and fault with this many seeds; each takes two minutes on one core.")
      ->capture_default_str();
  add_number(*sub, "--margin", run_options.terms.margin, {.low = 0, .high = 1},
             "Plan the size of the tests so that fairlight excludes biases of this part of the reference.")
      ->capture_default_str();
  add_text(*sub, "--seed", options->seed, "HEX",
           "Start at this seed, 1 to 16 hexadecimal digits. Fresh if not given.");
  begin_group(*sub, "Files");
  add_text(*sub, "--json", options->json, "F.json", "Write the table of judges to this JSON file.");
  add_threads(*sub, run_options.threads);
  add_examples(*sub, {"fairlight audit judges --seeds 2 --margin 0.01 --json judges.json"});
  sub->callback([options, &command] { command = [options] { return run(*options); }; });
}

}  // namespace fairlight

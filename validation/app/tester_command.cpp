#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include <nlohmann/json.hpp>

#include <fairlight/render/atomic_file.h>
#include <fairlight/render/parallel.h>
#include <fairlight/stats/seed.h>
#include <fairlight/validation/app/commands.h>
#include <fairlight/validation/app/options.h>
#include <fairlight/validation/app/progress.h>
#include <fairlight/validation/audit/ledger_audit.h>
#include <fairlight/validation/audit/tester_audit.h>

namespace fairlight {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TesterOutcome, name, runs, failures, limit)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CostOutcome, law, draws_per_cv2)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LedgerOutcome, bias, runs, runs_certified, runs_biased, ledgers, ledgers_biased,
                                   ledgers_wrong, median_finer)

namespace {

struct TesterOptions {
  std::string seed, json;
  bool brief = false;
  int threads = hardware_threads();

  // The audit. Checks that the output can be written.
  TesterAudit audit() const {
    if (!json.empty()) AtomicFile::check_writable(json);
    TesterAudit audit{seed.empty() ? fresh_seed() : parse_seed(seed), threads};
    if (brief) {
      audit.calibration_runs = 300;
      audit.power_seeds = 30;
      audit.cost_runs = 20;
    }
    return audit;
  }
};

void print_outcomes(const std::vector<TesterOutcome>& outcomes, const char* failures) {
  std::printf("%-44s %6s %9s %6s\n", "test", "runs", failures, "limit");
  for (const TesterOutcome& o : outcomes) {
    std::printf("%-44s %6d %9d %6d%s\n", o.name.c_str(), o.runs, o.failures, o.limit,
                o.passed() ? "" : "  <- over");
  }
}

bool print_cost(const std::vector<CostOutcome>& costs) {
  bool passed = true;
  std::printf("\n%-44s %s\n", "draws of the core test on right code, alpha 1e-8, beta 0.01", "in (CV/margin)^2");
  for (const CostOutcome& c : costs) {
    const bool over = c.limit > 0 && c.draws_per_cv2 - 5 * c.standard_error > c.limit;
    passed = passed && !over;
    std::printf("  %-42s %6.1f +- %.1f", c.law.c_str(), c.draws_per_cv2, c.standard_error);
    if (c.limit > 0) std::printf("  (at most %.0f)", c.limit);
    std::puts(over ? "  <- over" : "");
  }
  std::printf("  %-42s %6.1f\n  %-42s %6.1f\n", "z-test of fixed size", fixed_size_cost(1e-8, 0.01),
              "Wald's bound, one side", 2 * std::log(1 / 0.01));
  return passed;
}

bool print_uniformity(const std::vector<UniformityOutcome>& outcomes) {
  bool passed = true;
  std::printf("\n%-44s %8s %9s\n", "p-values of tests of fixed size", "entries", "least p");
  for (const UniformityOutcome& o : outcomes) {
    passed = passed && o.uniform == o.expected;
    std::printf("  %-42s %8d %9.1e  %s%s\n", o.name.c_str(), o.p_values, o.least,
                o.uniform ? "uniform" : "not uniform", o.uniform == o.expected ? "" : "  <- wrong");
  }
  return passed;
}

bool all_passed(const std::vector<TesterOutcome>& outcomes) {
  return std::all_of(outcomes.begin(), outcomes.end(), [](const TesterOutcome& o) { return o.passed(); });
}

int conclude(const TesterOptions& options, const TesterAudit& audit, nlohmann::json json, bool passed) {
  json["verdict"] = passed ? "certified" : "biased";
  json["seed"] = seed_text(audit.seed);
  if (!options.json.empty()) write_json(options.json, json);
  std::printf("\n%s (seed %s)\n",
              passed ? "the tester is as good as it says" : "the tester is not as good as it says",
              seed_text(audit.seed).c_str());
  return passed ? 0 : 1;
}

int calibration(const TesterOptions& options) {
  const TesterAudit audit = options.audit();
  const auto outcomes = audit_calibration(audit, progress_bar("calibration"));
  const auto costs = audit_cost(audit, progress_bar("cost"));
  const auto p_values = audit_uniformity(audit);
  std::printf("right code at alpha = 0.01, margin 0.1; a failure is any verdict but certified\n");
  print_outcomes(outcomes, "failures");
  const bool cheap = print_cost(costs);
  const bool uniform = print_uniformity(p_values);
  nlohmann::json json{{"tests", outcomes}, {"cost", costs}};
  for (const UniformityOutcome& o : p_values) {
    json["p_values"].push_back(
        {{"name", o.name}, {"entries", o.p_values}, {"least", o.least}, {"uniform", o.uniform}});
  }
  return conclude(options, audit, json, all_passed(outcomes) && cheap && uniform);
}

int power(const TesterOptions& options) {
  const TesterAudit audit = options.audit();
  const auto outcomes = audit_power(audit, progress_bar("power"));
  std::printf("draws off by the margin, 0.1, up and down; a miss is any verdict but biased, or without a range but undecided\n");
  print_outcomes(outcomes, "misses");
  return conclude(options, audit, {{"tests", outcomes}, {"cost", nlohmann::json::array()}}, all_passed(outcomes));
}

int ledger(const TesterOptions& options) {
  const TesterAudit audit = options.audit();
  const auto outcomes = audit_ledger(audit, progress_bar("ledger"));
  std::printf("ledgers of 100 runs at the margin 0.05, level 1e-8, miss rate 0.01\n");
  std::printf("%18s %10s %12s %14s %10s %14s %8s %8s\n", "bias, of a margin", "runs", "certified", "biased alone",
              "ledgers", "biased ledgers", "wrong", "finer");
  bool passed = true;
  for (const LedgerOutcome& o : outcomes) {
    passed = passed && o.passed();
    std::printf("%18.3f %10d %12d %14d %10d %14d %8d %8.1f%s\n", o.bias, o.runs, o.runs_certified, o.runs_biased,
                o.ledgers, o.ledgers_biased, o.ledgers_wrong, o.median_finer, o.passed() ? "" : "  <- wrong");
  }
  return conclude(options, audit, {{"ledgers", outcomes}}, passed);
}

void add_tester_command(CLI::App& audit, Command& command, const std::string& name, const std::string& help,
                        int (*run)(const TesterOptions&)) {
  auto* sub = audit.add_subcommand(name, help);
  auto options = std::make_shared<TesterOptions>();
  begin_group(*sub, "Runs");
  sub->add_flag("--short", options->brief, "Make a tenth of the runs.");
  add_text(*sub, "--seed", options->seed, "HEX",
           "Start at this seed, 1 to 16 hexadecimal digits. Fresh if not given.");
  begin_group(*sub, "Files");
  add_text(*sub, "--json", options->json, "F.json", "Write the table to this JSON file.");
  add_threads(*sub, options->threads);
  add_examples(*sub, {"fairlight audit " + name + " --short --json " + name + ".json"});
  sub->callback([options, &command, run] { command = [options, run] { return run(*options); }; });
}

}  // namespace

void add_tester_commands(CLI::App& audit, Command& command) {
  add_tester_command(audit, command, "calibration",
                     "Run the tests on right code: count how often they fail, and what they cost.", calibration);
  add_tester_command(audit, command, "power",
                     "Run the tests on code that is off by the margin: count how often they miss it.", power);
  add_tester_command(audit, command, "ledger",
                     "Add 100 runs up: show how fine a margin they certify, and which biases they find.", ledger);
}

}  // namespace fairlight

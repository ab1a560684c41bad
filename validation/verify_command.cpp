#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include <fairlight/render/parallel.h>
#include <fairlight/render/progress.h>
#include <fairlight/render/whole_file.h>
#include <fairlight/stats/seed.h>
#include <fairlight/validation/commands.h>
#include <fairlight/validation/conformance.h>
#include <fairlight/validation/ledger_run.h>
#include <fairlight/validation/registry.h>
#include <fairlight/validation/report.h>
#include <fairlight/validation/since.h>

namespace fairlight {
namespace {

struct VerifyOptions {
  std::vector<std::string> claims;
  bool list = false;
  std::string seed, json, ledger, since;
  Conformance conformance{{.seed = 0}, hardware_threads()};
};

int list(const std::vector<const Claim*>& claims) {
  for (const Claim* claim : claims) {
    std::printf("%-34s %-10s %s\n", claim->name.c_str(), claim->kind.c_str(), claim->statement.c_str());
  }
  return 0;
}

int exit_status(Verdict verdict) { return verdict == Verdict::certified ? 0 : verdict == Verdict::biased ? 1 : 3; }

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

void print_verdict(const std::vector<Outcome>& outcomes, const Conformance& conformance, double seconds) {
  const Verdict verdict = overall(outcomes);
  const auto failures = std::count_if(outcomes.begin(), outcomes.end(), [](const Outcome& outcome) {
    return outcome.finding.verdict != Verdict::certified;
  });
  if (verdict == Verdict::certified) {
    std::printf("certified: all of %zu claims hold to within their margins", outcomes.size());
  } else {
    std::printf("%s: %td of %zu claims failed", name(verdict), failures, outcomes.size());
  }
  std::printf(" (%.1f s, seed %s, false alarms %.0e a run, miss rate %.0e a claim)\n", seconds,
              seed_text(conformance.terms.seed).c_str(), conformance.terms.budget, conformance.terms.beta);
  print_depth(outcomes, conformance, seconds);
}

// The ledger is added to, not written anew.
void check_ledger(const VerifyOptions& options) {
  namespace fs = std::filesystem;
  if (options.json.empty() || options.ledger.empty()) return;
  if (fs::weakly_canonical(fs::absolute(options.json)) != fs::weakly_canonical(fs::absolute(options.ledger)))
    return;
  throw std::invalid_argument("--json and --ledger name the same file, \"" + options.json +
                              "\" (one would overwrite the other)");
}

int verify(const VerifyOptions& options) {
  std::vector<const Claim*> claims = select_claims(options.claims);
  if (!options.since.empty()) claims = claims_since(options.since, claims, this_build());
  if (options.list) return list(claims);
  if (claims.empty()) return 0;
  if (!options.json.empty()) WholeFile::check_writable(options.json);
  Conformance conformance = options.conformance;
  conformance.terms.seed = options.seed.empty() ? fresh_seed() : parse_seed(options.seed);
  check_ledger(options);
  std::optional<LedgerRun> ledger;
  if (!options.ledger.empty()) ledger.emplace(options.ledger, claims, this_build());
  conformance.evidence = ledger.has_value();
  const auto start = std::chrono::steady_clock::now();
  std::vector<Outcome> outcomes = run_claims(claims, conformance, progress_bar("verify"));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (ledger) ledger->add(outcomes, conformance);
  if (!options.json.empty()) write_json(options.json, outcomes_json(outcomes, conformance, seconds));
  print_outcomes(stdout, outcomes, conformance);
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
  app->add_option("claims", options->claims,
                  "Which claims: names, their first parts, or patterns; all if none given")
      ->type_name("CLAIM");
  app->add_flag("--list", options->list, "List the claims, and run nothing");
  app->add_option("--margin", options->conformance.terms.margin, "The relative bias to exclude")
      ->capture_default_str();
  app->add_option("--budget", options->conformance.terms.budget, "The probability of a false alarm in a whole run")
      ->capture_default_str();
  app->add_option("--seed", options->seed, "Replays a run: the 16 hexadecimal digits that it printed");
  app->add_option("--json", options->json, "The outcomes, as JSON")->type_name("F.json");
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

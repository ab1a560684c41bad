#include <algorithm>
#include <cstdio>
#include <memory>
#include <set>

#include <fairlight/render/atomic_file.h>
#include <fairlight/render/parallel.h>
#include <fairlight/stats/seed.h>
#include <fairlight/validation/app/commands.h>
#include <fairlight/validation/app/options.h>
#include <fairlight/validation/app/progress.h>
#include <fairlight/validation/audit/fault_audit.h>
#include <fairlight/validation/report/report.h>

namespace fairlight {
namespace {

struct AuditOptions {
  std::string seed, json;
  int seeds = 300;
  RunOptions run_options{{.seed = 0}, hardware_threads()};
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
  if (!options.json.empty()) AtomicFile::check_writable(options.json);
  RunOptions run_options = options.run_options;
  run_options.terms.seed = options.seed.empty() ? fresh_seed() : parse_seed(options.seed);
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

}  // namespace

void add_audit_command(CLI::App& program, Command& command) {
  auto* app = program.add_subcommand("audit", "Test the tests: wrong estimators must fail, right ones must not.");
  auto options = std::make_shared<AuditOptions>();
  auto* sub = app->add_subcommand(
      "faults", "Run wrong estimators through the claims: each must be found biased with every seed.");
  begin_group(*sub, "Runs");
  add_count(*sub, "--seeds", options->seeds, 1, 100000,
            "Run each fault with this many seeds; 300 take some eleven minutes on two cores.")
      ->capture_default_str();
  add_text(*sub, "--seed", options->seed, "HEX",
           "Start at this seed, 1 to 16 hexadecimal digits. Fresh if not given.");
  begin_group(*sub, "Files");
  add_text(*sub, "--json", options->json, "F.json", "Write the table of faults and claims to this JSON file.");
  add_threads(*sub, options->run_options.threads);
  add_examples(*sub, {"fairlight audit faults --seeds 10 --json faults.json"});
  sub->callback([options, &command] { command = [options] { return faults(*options); }; });
  add_tester_commands(*app, command);
  add_mutate_command(*app, command);
  add_judges_command(*app, command);
  add_domains_command(*app, command);
  add_examples(*app, {"fairlight audit faults --seeds 10", "fairlight audit calibration --short"});
}

}  // namespace fairlight

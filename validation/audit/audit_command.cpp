#include <algorithm>
#include <cstdio>
#include <memory>

#include <fairlight/render/parallel.h>
#include <fairlight/render/progress.h>
#include <fairlight/render/whole_file.h>
#include <fairlight/stats/seed.h>
#include <fairlight/validation/audit/fault_audit.h>
#include <fairlight/validation/commands.h>
#include <fairlight/validation/report.h>

namespace fairlight {
namespace {

struct AuditOptions {
  std::string seed, json;
  int seeds = 10;
  Conformance conformance{{.seed = 0}, hardware_threads()};
};

// A fault survives when no claim catches it every time.
std::vector<const Fault*> survivors(const std::vector<FaultOutcome>& outcomes) {
  std::vector<const Fault*> alive;
  for (const Fault& fault : fault_catalogue()) {
    const bool caught = std::any_of(outcomes.begin(), outcomes.end(), [&](const FaultOutcome& outcome) {
      return outcome.fault == &fault && outcome.caught == outcome.seeds;
    });
    if (!caught) alive.push_back(&fault);
  }
  return alive;
}

nlohmann::json faults_json(const std::vector<FaultOutcome>& outcomes) {
  nlohmann::json faults = nlohmann::json::array();
  for (const FaultOutcome& o : outcomes) {
    faults.push_back({{"name", o.fault->name},
                      {"class", o.fault->kind},
                      {"source", o.fault->source},
                      {"claim", o.claim},
                      {"effect", o.effect},
                      {"draws", o.draws},
                      {"caught", o.caught},
                      {"seeds", o.seeds}});
  }
  nlohmann::json alive = nlohmann::json::array();
  for (const Fault* fault : survivors(outcomes)) {
    alive.push_back({{"name", fault->name}, {"reason", "no claim caught it with every seed"}});
  }
  return {{"faults", faults}, {"survivors", alive}};
}

int faults(const AuditOptions& options) {
  if (!options.json.empty()) WholeFile::check_writable(options.json);
  Conformance conformance = options.conformance;
  conformance.terms.seed = options.seed.empty() ? fresh_seed() : parse_seed(options.seed);
  const auto outcomes = audit_faults(conformance, options.seeds, progress_bar("audit faults"));
  if (!options.json.empty()) write_json(options.json, faults_json(outcomes));
  std::printf("%-28s %-34s %10s %12s %8s\n", "fault", "claim", "effect", "draws", "caught");
  for (const FaultOutcome& o : outcomes) {
    std::printf("%-28s %-34s %+10.2e %12llu %4d/%d\n", o.fault->name.c_str(), o.claim.c_str(), o.effect,
                static_cast<unsigned long long>(o.draws), o.caught, o.seeds);
  }
  const auto alive = survivors(outcomes);
  std::printf("%zu of %zu faults caught with every seed (first seed %s)\n", fault_catalogue().size() - alive.size(),
              fault_catalogue().size(), seed_text(conformance.terms.seed).c_str());
  for (const Fault* fault : alive) std::printf("survivor: %s\n", fault->name.c_str());
  return alive.empty() ? 0 : 1;
}

}  // namespace

void add_audit_command(CLI::App& program, Command& command) {
  auto* app = program.add_subcommand("audit", "Test the tests");
  auto options = std::make_shared<AuditOptions>();
  auto* sub = app->add_subcommand("faults", "Run wrong estimators through the claims: each must be found biased");
  sub->add_option("--seeds", options->seeds, "How many seeds for each")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  sub->add_option("--seed", options->seed, "The first seed; fresh if not given");
  sub->add_option("--json", options->json, "The matrix, as JSON")->type_name("F.json");
  sub->add_option("--threads", options->conformance.threads, "Threads")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  sub->callback([options, &command] { command = [options] { return faults(*options); }; });
  add_tester_commands(*app, command);
}

}  // namespace fairlight

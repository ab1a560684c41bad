#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include <fairlight/render/atomic_file.h>
#include <fairlight/stats/seed.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/app/commands.h>
#include <fairlight/validation/app/options.h>
#include <fairlight/validation/run/ledger.h>
#include <fairlight/validation/run/registry.h>
#include <fairlight/validation/run/run_claims.h>

namespace fairlight {
namespace {

void add_and_tell(Ledger& ledger, const std::string& path) {
  ledger.add_file(path);
  if (ledger.torn()) std::printf("the last line of %s had been cut off, and is left out\n", path.c_str());
}

std::string margin_text(double margin) {
  if (std::isinf(margin)) return "none";
  return formatted("%.1e", margin);
}

// Prints the ledger. Uses the level and the miss rate that each claim has in a run of the whole
// registry of this program.
int show(const std::string& path) {
  Ledger ledger;
  add_and_tell(ledger, path);
  const Manifest manifest = manifest_of({{.seed = 0}});
  std::printf("%-40s %-16s %6s %14s %9s\n", "claim", "sources", "runs", "draws", "margin");
  bool biased = false;
  for (const auto& item : ledger.entries()) {
    const LedgerEntry& entry = item.second;
    const bool known =
        std::ranges::any_of(registry(), [&](const Claim& claim) { return claim.name == entry.claim; });
    std::string margin = "(not a claim of this program)";
    if (known) {
      const Trial trial = manifest.trial(entry.claim);
      const bool refuted = entry.evidence_sum.biased(trial.alpha);
      margin = refuted ? "biased" : margin_text(entry.evidence_sum.certified_margin(trial.beta));
      biased = biased || refuted;
    }
    std::printf("%-40s %-16s %6zu %14llu %9s\n", entry.claim.c_str(), seed_text(entry.content).c_str(),
                entry.seeds.size(), static_cast<unsigned long long>(entry.draws), margin.c_str());
  }
  return biased ? 1 : 0;
}

// Refuses an output that is also an input. Replacing a ledger would lose what other runs append to
// it meanwhile.
void check_output(const std::vector<std::string>& inputs, const std::string& output) {
  namespace fs = std::filesystem;
  AtomicFile::check_writable(output);
  for (const std::string& input : inputs) {
    if (fs::weakly_canonical(fs::absolute(input)) != fs::weakly_canonical(fs::absolute(output))) continue;
    throw std::invalid_argument("-o names \"" + input + "\", which is to be merged (give another name)");
  }
}

int merge(const std::vector<std::string>& inputs, const std::string& output) {
  check_output(inputs, output);
  Ledger all;
  for (const std::string& input : inputs) add_and_tell(all, input);
  write_whole(output, all.text());
  std::printf("%zu ledgers merged, %zu entries left out that were there already: %s\n", inputs.size(),
              all.repeated(), output.c_str());
  return 0;
}

void add_show(CLI::App& ledger, Command& command) {
  auto* app = ledger.add_subcommand("show", "Show the runs, draws and certified margin of each claim in a ledger.");
  auto path = std::make_shared<std::string>();
  begin_group(*app, "Files");
  add_text(*app, "ledger", *path, "F", "Show this ledger, which `fairlight verify --ledger` made.")->required();
  add_examples(*app, {"fairlight ledger show evidence.txt"});
  app->callback([path, &command] { command = [path] { return show(*path); }; });
}

void add_merge(CLI::App& ledger, Command& command) {
  auto* app = ledger.add_subcommand("merge", "Merge ledgers into one; a run that is in several counts once.");
  auto inputs = std::make_shared<std::vector<std::string>>();
  auto output = std::make_shared<std::string>();
  begin_group(*app, "Files");
  app->add_option("ledgers", *inputs, "Merge these ledgers.")->required()->type_name("F");
  add_text(*app, "-o", *output, "F",
           "Write the merged ledger to this file: a line for each claim and state of its sources.")
      ->required();
  add_examples(*app, {"fairlight ledger merge mine.txt yours.txt -o both.txt"});
  app->callback([inputs, output, &command] { command = [inputs, output] { return merge(*inputs, *output); }; });
}

}  // namespace

void add_ledger_command(CLI::App& program, Command& command) {
  auto* app = program.add_subcommand("ledger", "Show or merge files in which the evidence of runs adds up.");
  add_show(*app, command);
  add_merge(*app, command);
  add_examples(*app, {"fairlight ledger show evidence.txt"});
}

}  // namespace fairlight

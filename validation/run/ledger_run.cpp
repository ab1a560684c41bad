#include <algorithm>

#include <fairlight/render/atomic_file.h>
#include <fairlight/stats/hash.h>
#include <fairlight/validation/run/ledger_run.h>
#include <fairlight/validation/run/registry.h>

namespace fairlight {
namespace {

void print_torn(std::FILE* out, const std::string& path, const Ledger& ledger) {
  if (ledger.torn())
    std::fprintf(out, "ledger: the last line of %s had been cut off, and is left out\n", path.c_str());
}

}  // namespace

LedgerRun::LedgerRun(const std::string& path, const std::vector<const Claim*>& claims, const BuildPlaces& places)
    : path_(path) {
  AtomicFile::check_writable(path);
  print_torn(stdout, path, Ledger::read_if_there(path));
  Sources sources(places);
  const auto add_file = [&](const std::string& file) {
    if (!contents_.contains(file)) contents_[file] = sources.content(file);
  };
  for (const Claim* claim : claims) add_file(claim->file);
  for (const Claim& claim : registry()) {  // every instruction set has the same rows
    if (claim.adds_up) add_file(claim.file);
  }
}

std::uint64_t LedgerRun::content_of(const Claim& claim) const {
  return hash_of(claim.instructions, contents_.at(claim.file));
}

const LedgerEntry* LedgerRun::entry_of(const Claim& claim) const {
  return ledger_.find({claim.name, content_of(claim)});
}

void LedgerRun::add(std::vector<Outcome>& outcomes, std::vector<ComponentOutcome>& components,
                    const RunOptions& run_options) {
  std::vector<LedgerEntry> entries;
  for (const Outcome& outcome : outcomes) {
    const EvidenceSum evidence(outcome.evidence.margin_grid);
    if (evidence.empty()) continue;
    const Claim& claim = *outcome.claim;
    entries.push_back({claim.name, content_of(claim), {run_options.terms.seed}, outcome.finding.draws, evidence});
  }
  if (!entries.empty()) Ledger::append(path_, entries);
  ledger_ = Ledger::read_if_there(path_);
  runs_ = kept_ = 0;
  finer_.clear();
  const Manifest manifest = manifest_of(run_options);
  for (Outcome& outcome : outcomes) judge(outcome, manifest.trial(outcome.claim->name));
  for (ComponentOutcome& component : components) judge(component, run_options);
}

void LedgerRun::judge(Outcome& outcome, const Trial& trial) {
  const LedgerEntry* entry = entry_of(*outcome.claim);
  if (entry == nullptr) return;
  ++kept_;
  runs_ = std::max(runs_, entry->seeds.size());
  outcome.ledger = {entry->seeds.size(), entry->evidence_sum.certified_margin(trial.beta)};
  const double finer = trial.margin / outcome.ledger->margin;
  if (finer > 1) finer_.push_back(finer);
  if (!entry->evidence_sum.biased(trial.alpha) || outcome.finding.verdict == Verdict::biased) return;
  outcome.finding.verdict = Verdict::biased;
  outcome.finding.note =
      "biased by all " + std::to_string(entry->seeds.size()) + " runs of the ledger together, not by this one";
}

// Claims that did not run this time count as well: a choice of claims by what they have shown would
// void the level.
void LedgerRun::judge(ComponentOutcome& component, const RunOptions& run_options) const {
  std::vector<const Claim*> claims;
  std::size_t runs = 0;
  for (const Claim& claim : registry(component.instructions)) claims.push_back(&claim);
  const CommonBias bias =
      common_bias(component.name, component.instructions, claims, [&](const Claim& claim) -> EvidenceSum {
        const LedgerEntry* entry = entry_of(claim);
        if (entry == nullptr) return {};
        runs = std::max(runs, entry->seeds.size());
        return entry->evidence_sum;
      });
  component.ledger = {runs, bias.excluded(run_options.terms.beta)};
  if (component.verdict == Verdict::biased || !bias.biased(component_level(run_options))) return;
  component.verdict = Verdict::biased;
  component.upward = bias.upward();
}

void LedgerRun::print(std::FILE* out) const {
  std::fprintf(out, "ledger: %s, %zu runs: ", path_.c_str(), runs_);
  if (kept_ == 0) {
    std::fprintf(out, "no claim that rests on an exact test\n");
    return;
  }
  std::fprintf(out, "%zu of %zu claims certified at a finer margin than this run's", finer_.size(), kept_);
  std::vector<double> sorted = finer_;
  std::ranges::sort(sorted);
  if (!sorted.empty()) std::fprintf(out, ", half of them at least %.1f times", sorted[sorted.size() / 2]);
  std::fputs("\n", out);
}

}  // namespace fairlight

#include <algorithm>

#include <fairlight/render/atomic_file.h>
#include <fairlight/stats/hash.h>
#include <fairlight/validation/run/ledger_run.h>

namespace fairlight {
namespace {

std::vector<LedgerEntry> entries_of(const std::vector<Outcome>& outcomes, const RunOptions& run_options,
                                    const std::map<const Claim*, std::uint64_t>& contents) {
  std::vector<LedgerEntry> entries;
  for (const Outcome& outcome : outcomes) {
    const EvidenceSum evidence_sum(outcome.evidence.margin_grid);
    if (evidence_sum.empty()) continue;
    entries.push_back({outcome.claim->name,
                       contents.at(outcome.claim),
                       {run_options.terms.seed},
                       outcome.finding.draws,
                       evidence_sum});
  }
  return entries;
}

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
  std::map<std::string, std::uint64_t> contents;  // by file
  for (const Claim* claim : claims) {
    if (!contents.contains(claim->file)) contents[claim->file] = sources.content(claim->file);
    contents_[claim] = hash_of(claim->instructions, contents[claim->file]);
  }
}

void LedgerRun::add(std::vector<Outcome>& outcomes, const RunOptions& run_options) {
  const std::vector<LedgerEntry> entries = entries_of(outcomes, run_options, contents_);
  if (!entries.empty()) Ledger::append(path_, entries);
  ledger_ = Ledger::read_if_there(path_);
  runs_ = kept_ = 0;
  finer_.clear();
  const Manifest manifest = manifest_of(run_options);
  for (Outcome& outcome : outcomes) judge(outcome, manifest.trial(outcome.claim->name));
}

void LedgerRun::judge(Outcome& outcome, const Trial& trial) {
  const LedgerEntry* entry = ledger_.find({trial.claim, contents_.at(outcome.claim)});
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

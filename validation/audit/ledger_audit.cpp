#include <algorithm>

#include <fairlight/estimators/stream.h>
#include <fairlight/render/parallel.h>
#include <fairlight/stats/evidence.h>
#include <fairlight/stats/mean_test.h>
#include <fairlight/validation/audit/ledger_audit.h>

namespace fairlight {
namespace {

constexpr int runs_a_ledger = 100;
constexpr double margin = 0.05;
constexpr double alpha = 1e-8;
constexpr double beta = 0.01;
constexpr double a_third = 1.0 / 3;
constexpr double on_the_grid = 0.3125;  // of the margin: 1/64

struct Fate {
  int runs_biased = 0;
  int runs_certified = 0;
  bool biased = false;  // after any run
  double finer = 0;
};

// Runs a ledger's tests one after the other, with seeds that no other ledger uses.
Fate fate_of(std::uint64_t seed, double bias) {
  EvidenceSum evidence_sum;
  Fate fate;
  for (int r = 0; r < runs_a_ledger; ++r) {
    const Trial trial{"ledger run " + std::to_string(r) + " bias " + std::to_string(bias), seed, alpha, beta,
                      margin};
    const LeavingRun run = run_for_sum(trial, bias * margin);
    fate.runs_biased += run.finding.verdict == Verdict::biased ? 1 : 0;
    fate.runs_certified += run.finding.verdict == Verdict::certified ? 1 : 0;
    evidence_sum.append(run.evidence_sum);
    fate.biased = fate.biased || evidence_sum.biased(alpha);
  }
  fate.finer = margin / evidence_sum.certified_margin(beta);
  return fate;
}

LedgerOutcome outcome_of(double bias, const std::vector<Fate>& fates) {
  LedgerOutcome outcome{bias, 0, 0, 0, static_cast<int>(fates.size()), 0, 0, 0};
  std::vector<double> finer;
  for (const Fate& fate : fates) {
    outcome.runs += runs_a_ledger;
    outcome.runs_biased += fate.runs_biased;
    outcome.runs_certified += fate.runs_certified;
    outcome.ledgers_biased += fate.biased ? 1 : 0;
    outcome.ledgers_wrong += bias > 0 && 1 / fate.finer <= bias ? 1 : 0;
    finer.push_back(fate.finer);
  }
  std::ranges::sort(finer);
  outcome.median_finer = finer[(finer.size() - 1) / 2];
  return outcome;
}

}  // namespace

LeavingRun run_for_sum(const Trial& trial, double bias) {
  Evidence evidence;
  Trial watched = trial;
  watched.evidence = &evidence;
  const StreamKey key(trial.seed, trial.claim);
  const auto draw = [&](std::uint64_t i) { return 2 * PhiloxStream<double>(key, 0, i).next() * (1 + bias); };
  const Finding finding = test_means(watched, {{1, 0, 2.5}}, one_channel(draw));
  return {finding, EvidenceSum(evidence.margin_grid)};
}

bool LedgerOutcome::passed() const {
  if (ledgers_wrong > binomial_limit(ledgers, beta)) return false;
  if (bias == 0) return median_finer >= 8 && ledgers_biased == 0;
  return bias < a_third || (ledgers_biased == ledgers && 2 * runs_certified > runs);
}

std::vector<LedgerOutcome> audit_ledger(const TesterAudit& audit, const Progress& progress) {
  const std::vector<double> biases{0, 1.0 / 6, 1.0 / 4, on_the_grid, a_third};
  const auto ledgers = static_cast<std::size_t>(audit.power_seeds);
  std::vector<std::vector<Fate>> fates(biases.size(), std::vector<Fate>(ledgers));
  const auto one = [&](std::size_t unit) {
    const std::size_t b = unit / ledgers, l = unit % ledgers;
    fates[b][l] = fate_of(audit.seed + l, biases[b]);
  };
  for_each_unit(biases.size() * ledgers, audit.threads, one, progress);
  std::vector<LedgerOutcome> outcomes;
  for (std::size_t b = 0; b < biases.size(); ++b) outcomes.push_back(outcome_of(biases[b], fates[b]));
  return outcomes;
}

}  // namespace fairlight

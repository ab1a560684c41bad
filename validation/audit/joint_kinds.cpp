#include <fairlight/estimators/stream.h>
#include <fairlight/stats/evidence.h>
#include <fairlight/validation/audit/joint_kinds.h>
#include <fairlight/validation/audit/ledger_audit.h>

namespace fairlight {
namespace {

// Sums runs with four times the margin until their evidence sum has a verdict. A bias of one margin
// is within the margin of each run.
Finding evidence_sum(const Trial& trial, double bias) {
  constexpr int most_runs = 1000;
  Finding finding{Verdict::undecided, Guarantee::exact, trial.margin};
  EvidenceSum evidence_sum;
  for (int r = 0; r < most_runs && finding.verdict == Verdict::undecided; ++r) {
    Trial one = trial;
    one.claim += " run " + std::to_string(r);
    one.margin = 4 * trial.margin;
    const LeavingRun run = run_for_sum(one, bias);
    evidence_sum.append(run.evidence_sum);
    finding.draws += run.finding.draws;
    if (evidence_sum.certified_margin(trial.beta) <= trial.margin) finding.verdict = Verdict::certified;
    if (evidence_sum.biased(trial.alpha)) finding.verdict = Verdict::biased;
  }
  return finding;
}

// A component of sixty claims, each tested to three times the margin.
Finding component(const Trial& trial, double bias) {
  const CommonBias common = simulate_component(trial, 60, 3 * trial.margin, bias).common;
  Finding finding{Verdict::undecided, Guarantee::exact, trial.margin};
  if (common.excluded(trial.beta) <= trial.margin) finding.verdict = Verdict::certified;
  if (common.biased(trial.alpha)) finding.verdict = Verdict::biased;
  return finding;
}

Finding claim_of_component(const Trial& trial, int kind, double bias) {
  const StreamKey key(trial.seed, trial.claim);
  const auto draw = [&](std::uint64_t i) { return PhiloxStream<double>(key, 0, i).next(); };
  if (kind == 0) {
    const auto uniform = [&](std::uint64_t i) { return 2 * draw(i) * (1 + bias); };
    return test_means(trial, {{1, 0, 2.8}}, one_channel(uniform));
  }
  if (kind == 1) {
    const auto coin = [&](std::uint64_t i) { return draw(i) < (1 + bias) / 8 ? 8.0 : 0.0; };
    return test_means(trial, {{1, 0, 8}}, one_channel(coin));
  }
  return test_means(trial, {{1, 0, 2.8}, {1.5, 0, 4.2}, {0.5, 0, 1.4}},
                    [&](std::uint64_t first, std::vector<std::vector<double>>& channels) {
                      for (std::size_t i = 0; i < channels[0].size(); ++i) {
                        const double x = 2 * draw(first + i) * (1 + bias);
                        channels[0][i] = x;
                        channels[1][i] = 1.5 * x;
                        channels[2][i] = 0.5 * x;
                      }
                    });
}

}  // namespace

SimulatedComponent simulate_component(const Trial& trial, int claims, double margin, double bias) {
  SimulatedComponent component;
  for (int c = 0; c < claims; ++c) {
    Evidence evidence;
    evidence.courses = false;
    Trial one = trial;
    one.claim += " claim " + std::to_string(c);
    one.margin = margin;
    one.evidence = &evidence;
    component.failed += claim_of_component(one, c % 3, bias).verdict == Verdict::biased ? 1 : 0;
    component.common.add(EvidenceSum(evidence.margin_grid));
  }
  return component;
}

const std::vector<TestKind>& joint_kinds() {
  static const std::vector<TestKind> kinds{{"account", false, evidence_sum}, {"component", false, component}};
  return kinds;
}

}  // namespace fairlight

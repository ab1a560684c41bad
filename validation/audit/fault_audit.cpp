#include <mutex>

#include <fairlight/render/parallel.h>
#include <fairlight/validation/audit/fault_audit.h>

namespace fairlight {

std::vector<FaultOutcome> audit_faults(const Conformance& conformance, int seeds, const Progress& progress) {
  struct Cell {
    const Fault* fault;
    const Claim* claim;
  };
  std::vector<Cell> cells;
  for (const Fault& fault : fault_catalogue()) {
    for (const Claim& claim : fault.claims) cells.push_back({&fault, &claim});
  }
  const auto per_cell = static_cast<std::size_t>(seeds);
  std::vector<Finding> findings(cells.size() * per_cell);
  const Manifest manifest = manifest_of(conformance);
  std::mutex mutex;
  std::size_t done = 0;
  for_each_unit(static_cast<int>(findings.size()), conformance.threads, [&](int unit) {
    const auto i = static_cast<std::size_t>(unit);
    const Claim& claim = *cells[i / per_cell].claim;
    Trial trial = manifest.trial(claim.name);
    trial.seed += i % per_cell;
    findings[i] = claim.check(trial);
    const std::lock_guard lock(mutex);
    if (progress) progress(static_cast<double>(++done) / static_cast<double>(findings.size()));
  });
  std::vector<FaultOutcome> outcomes;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    FaultOutcome outcome{cells[c].fault, cells[c].claim->name, 0, 0, 0, seeds};
    for (std::size_t s = 0; s < per_cell; ++s) {
      const Finding& finding = findings[c * per_cell + s];
      outcome.effect += finding.bias / seeds;
      outcome.draws += finding.draws;
      outcome.caught += finding.verdict == Verdict::biased ? 1 : 0;
    }
    outcome.draws /= per_cell;
    outcomes.push_back(outcome);
  }
  return outcomes;
}

}  // namespace fairlight

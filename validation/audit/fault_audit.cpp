#include <algorithm>

#include <fairlight/render/parallel.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/audit/fault_audit.h>
#include <fairlight/validation/run/clock.h>

namespace fairlight {
namespace {

// The result of one seed.
struct Capture {
  Finding finding;
  double seconds = 0;
};

Capture capture(const Claim& claim, const Trial& trial) {
  const Clock clock;
  const Finding finding = claim.check(trial);
  return {finding, clock.seconds()};
}

// The result of a fault in a claim, in words.
std::string in_words(const FaultOutcome& o) {
  return formatted("%s: caught %d times of %d, with a bias of %.1e at a margin of %.1e", o.claim->name.c_str(),
                   o.caught, o.seeds, o.effect, o.margin);
}

}  // namespace

std::vector<FaultOutcome> audit_faults(const RunOptions& run_options, int seeds, const Progress& progress) {
  std::vector<FaultOutcome> outcomes;
  for (const Fault& fault : fault_catalogue()) {
    for (const Claim& claim : fault.claims) outcomes.push_back({.fault = &fault, .claim = &claim, .seeds = seeds});
  }
  const auto per_cell = static_cast<std::size_t>(seeds);
  std::vector<Capture> captures(outcomes.size() * per_cell);
  const Manifest manifest = manifest_of(run_options);
  const auto one = [&](std::size_t i) {
    const Claim& claim = *outcomes[i / per_cell].claim;
    Trial trial = manifest.trial(claim.name);
    trial.seed += i % per_cell;
    captures[i] = capture(claim, trial);
  };
  for_each_unit(captures.size(), run_options.threads, one, progress);
  for (std::size_t i = 0; i < captures.size(); ++i) {
    FaultOutcome& outcome = outcomes[i / per_cell];
    const auto& [finding, elapsed] = captures[i];
    outcome.effect += finding.bias / seeds;
    if (i % per_cell == 0) outcome.note = finding.note;
    outcome.margin = finding.margin;
    outcome.draws += finding.draws;
    outcome.seconds += elapsed / seeds;
    outcome.caught += finding.verdict == Verdict::biased ? 1 : 0;
  }
  for (FaultOutcome& outcome : outcomes) outcome.draws /= per_cell;
  return outcomes;
}

std::vector<Survivor> survivors(const std::vector<FaultOutcome>& outcomes) {
  std::vector<Survivor> alive;
  for (const Fault& fault : fault_catalogue()) {
    std::string reason;
    bool caught = false;
    for (const FaultOutcome& o : outcomes) {
      if (o.fault != &fault) continue;
      caught = caught || o.caught == o.seeds;
      reason += (reason.empty() ? "" : "; ") + in_words(o);
    }
    if (caught) continue;
    const bool expected = !fault.survives.empty();
    alive.push_back({&fault, expected ? fault.survives : "a hole in the claims: " + reason, expected});
  }
  return alive;
}

}  // namespace fairlight

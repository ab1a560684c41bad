#include <chrono>
#include <mutex>

#include <fairlight/render/parallel.h>
#include <fairlight/validation/conformance.h>
#include <fairlight/validation/registry.h>

namespace fairlight {

Manifest manifest_of(const Conformance& conformance) {
  std::vector<Manifest::Row> rows;
  for (const Claim& c : registry()) rows.push_back({c.name, c.weight, c.margin_factor});
  return Manifest(rows, conformance.terms);
}

std::vector<Outcome> run_claims(const std::vector<const Claim*>& claims, const Conformance& conformance,
                                const Progress& progress) {
  const Manifest manifest = manifest_of(conformance);
  std::vector<Outcome> outcomes(claims.size());
  std::mutex mutex;
  std::size_t done = 0;
  for_each_unit(static_cast<int>(claims.size()), conformance.threads, [&](int unit) {
    const auto i = static_cast<std::size_t>(unit);
    const auto start = std::chrono::steady_clock::now();
    Trial trial = manifest.trial(claims[i]->name);
    Evidence evidence;
    if (conformance.evidence) trial.evidence = &evidence;
    const Finding finding = claims[i]->check(trial);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    outcomes[i] = {claims[i], finding, seconds, std::move(evidence)};
    const std::lock_guard lock(mutex);
    if (progress) progress(static_cast<double>(++done) / static_cast<double>(claims.size()));
  });
  return outcomes;
}

Verdict overall(const std::vector<Outcome>& outcomes) {
  Verdict verdict = Verdict::certified;
  for (const Outcome& outcome : outcomes) verdict = worse(verdict, outcome.finding.verdict);
  return verdict;
}

}  // namespace fairlight

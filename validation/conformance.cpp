#include <algorithm>
#include <chrono>
#include <mutex>
#include <stdexcept>

#include <fairlight/render/parallel.h>
#include <fairlight/stats/budget.h>
#include <fairlight/validation/conformance.h>
#include <fairlight/validation/registry.h>

namespace fairlight {

Trial trial_of(const std::string& claim, const Conformance& conformance) {
  const auto& rows = registry();
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const Claim& c) { return c.name == claim; });
  if (row == rows.end())
    throw std::invalid_argument("\"" + claim + "\" is not in the registry (and so has no share)");
  const double margin = conformance.margin * row->margin_factor;
  if (!(conformance.margin > 0 && margin < 1)) {
    throw std::invalid_argument("the margin must be in (0," + std::to_string(1 / row->margin_factor) + ") for " +
                                claim + " (its own is " + std::to_string(row->margin_factor) + " times that)");
  }
  std::vector<double> weights;
  for (const Claim& c : rows) weights.push_back(c.weight);
  const Budget budget(conformance.budget, weights);
  return {claim, conformance.seed, budget.share(static_cast<std::size_t>(row - rows.begin())), conformance.beta,
          margin};
}

std::vector<Outcome> run_claims(const std::vector<const Claim*>& claims, const Conformance& conformance,
                                const Progress& progress) {
  std::vector<Outcome> outcomes(claims.size());
  std::mutex mutex;
  std::size_t done = 0;
  for_each_unit(static_cast<int>(claims.size()), conformance.threads, [&](int unit) {
    const auto i = static_cast<std::size_t>(unit);
    const auto start = std::chrono::steady_clock::now();
    const Finding finding = claims[i]->check(trial_of(claims[i]->name, conformance));
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    outcomes[i] = {claims[i], finding, seconds};
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

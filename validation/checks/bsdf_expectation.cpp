#include <algorithm>

#include <fairlight/stats/seed.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/checks/bsdf_expectation.h>

namespace fairlight {

Expectation expect_bsdf(const Site& site, const BsdfUnderTest& bsdf, const BsdfTerms& terms) {
  const Trial trial = trial_at(site, terms.margin);
  const std::vector<BsdfFinding> findings = check_bsdf(trial, bsdf, terms);
  std::string message;
  for (const auto& [check, statement, finding] : findings) {
    if (finding.verdict == Verdict::certified) continue;
    message += formatted("%s: %s: that %s\n", name(finding.verdict), check.c_str(), statement.c_str());
    message += formatted("  %s\n", finding.note.c_str());
  }
  const bool met = message.empty();
  message += formatted("  %zu checks, level %.1e, miss rate %.0e\n", findings.size(), trial.alpha, trial.beta);
  message += "  again: FAIRLIGHT_SEED=" + seed_text(trial.seed) + " " + site.replay + "\n";
  return {met, message};
}

}  // namespace fairlight

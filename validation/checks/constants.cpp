#include <algorithm>
#include <cmath>
#include <string>

#include <fairlight/stats/text.h>
#include <fairlight/validation/checks/constants.h>

namespace fairlight {

Finding check_constant(const Trial& trial, double reference, double tolerance, const Draws& draws) {
  constexpr std::uint64_t enough = 102'400;
  constexpr std::size_t block = 64;
  const DrawBlock draw = draws.independent(StreamKey(trial.seed, trial.claim));
  std::vector channels(1, std::vector<double>(block));
  Finding finding{.verdict = Verdict::certified, .guarantee = Guarantee::exact, .margin = tolerance};
  // If the share p of draws is off, n draws show none of them with probability (1 - p)^n.
  finding.note = formatted("all draws but a share of %.1e, at a miss rate of %g %%",
                           1 - std::pow(trial.beta, 1.0 / static_cast<double>(enough)), 100 * trial.beta);
  for (std::uint64_t first = 0; first < enough; first += block) {
    draw(first, channels);
    for (const double value : channels[0]) {
      const double error = value / reference - 1;
      ++finding.draws;
      if (!(std::abs(error) <= std::abs(finding.bias))) finding.bias = error;
      finding.interval = {std::min(finding.interval.lo, error), std::max(finding.interval.hi, error)};
      if (std::abs(error) <= tolerance) continue;
      finding.verdict = Verdict::biased;
      finding.guarantee = Guarantee::deterministic;  // one wrong draw refutes "every draw"
      finding.note = formatted("draw %llu is off by %g times what is allowed",
                               static_cast<unsigned long long>(finding.draws - 1), error / tolerance);
      return finding;
    }
  }
  return finding;
}

}  // namespace fairlight

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
  Finding finding{.verdict = Verdict::certified, .guarantee = Guarantee::deterministic, .margin = tolerance};
  for (std::uint64_t first = 0; first < enough; first += block) {
    draw(first, channels);
    for (const double value : channels[0]) {
      const double error = value / reference - 1;
      ++finding.draws;
      if (!(std::abs(error) <= std::abs(finding.bias))) finding.bias = error;
      finding.interval = {std::min(finding.interval.lo, error), std::max(finding.interval.hi, error)};
      if (std::abs(error) <= tolerance) continue;
      finding.verdict = Verdict::biased;
      finding.note = formatted("draw %llu is off by %g times what is allowed",
                               static_cast<unsigned long long>(finding.draws - 1), error / tolerance);
      return finding;
    }
  }
  return finding;
}

}  // namespace fairlight

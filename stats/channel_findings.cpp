#include <cmath>
#include <limits>

#include <fairlight/stats/channel_findings.h>
#include <fairlight/stats/text.h>

namespace fairlight {

std::size_t detail::worst_channel(const std::vector<Finding>& findings) {
  const auto rank = [](const Finding& f) {
    return f.verdict == Verdict::biased ? 2 : f.verdict == Verdict::undecided ? 1 : 0;
  };
  std::size_t worst = 0;
  for (std::size_t c = 1; c < findings.size(); ++c) {
    const int more = rank(findings[c]) - rank(findings[worst]);
    if (more > 0 || (more == 0 && std::abs(findings[c].bias) > std::abs(findings[worst].bias))) worst = c;
  }
  return worst;
}

std::string detail::channel_name(std::size_t channel, std::size_t channels) {
  return channels == 1 ? "" : formatted("channel %zu of 0 to %zu: ", channel, channels - 1);
}

Finding detail::found_in_pilot(const Trial& trial, const BadDraw& bad) {
  Finding finding{Verdict::biased, Guarantee::deterministic, trial.margin};
  finding.draws = bad.draw() + 1;
  finding.note = std::string(bad.what()) + ", in the pilot";
  return with_token(trial, finding);
}

Finding detail::found_in_pilot(const Trial& trial, const NoMoreDraws& spent) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Finding finding{Verdict::undecided, Guarantee::asymptotic, trial.margin, 0, {-infinite, infinite}};
  finding.note = std::string(spent.what()) + ", in the pilot (raise the cap)";
  return with_token(trial, finding);
}

}  // namespace fairlight

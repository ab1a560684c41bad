#include <cmath>
#include <limits>

#include <fairlight/stats/channel_findings.h>
#include <fairlight/stats/text.h>

namespace fairlight {

namespace {

// The size of a channel's bias; for a one-sided claim, whose interval has an open end, its value in
// the excluded direction.
double size_of_bias(const Finding& finding) {
  const bool open_below = std::isinf(finding.interval.lo);
  const bool open_above = std::isinf(finding.interval.hi);
  if (open_below == open_above) return std::abs(finding.bias);
  return open_below ? finding.bias : -finding.bias;
}

// Whether the interval excludes 0. Beyond 0 on the side that a one-sided claim leaves open, nothing
// is wrong.
bool excludes_zero(const Interval& bias) {
  return (bias.lo > 0 && std::isfinite(bias.hi)) || (bias.hi < 0 && std::isfinite(bias.lo));
}

}  // namespace

bool detail::is_worse(const Finding& a, const Finding& b) {
  if (a.verdict != b.verdict) return worse(a.verdict, b.verdict) == a.verdict;
  if (excludes_zero(a.interval) != excludes_zero(b.interval)) return excludes_zero(a.interval);
  return size_of_bias(a) > size_of_bias(b);
}

std::size_t detail::worst_channel(const std::vector<Finding>& findings) {
  std::size_t worst = 0;
  for (std::size_t c = 1; c < findings.size(); ++c) {
    if (is_worse(findings[c], findings[worst])) worst = c;
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
  finding.note = std::string(spent.what()) + ", in the pilot (allow more)";
  return with_token(trial, finding);
}

}  // namespace fairlight

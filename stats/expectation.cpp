#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include <fairlight/stats/expectation.h>
#include <fairlight/stats/seed.h>
#include <fairlight/stats/text.h>

namespace fairlight {
namespace {

// A histogram with 16 bars. NaNs and infinities are counted below it.
std::string histogram(std::vector<double> sample) {
  constexpr std::size_t bars = 16;
  const auto not_finite = std::erase_if(sample, [](double x) { return !std::isfinite(x); });
  const std::string below = not_finite == 0 ? ""
                                            : formatted("  %zu more draws are not finite numbers\n",
                                                        static_cast<std::size_t>(not_finite));
  if (sample.empty()) return below;
  const auto [least, greatest] = std::minmax_element(sample.begin(), sample.end());
  const double low = *least;
  const double width = *greatest / bars - low / bars;  // greatest - low could overflow
  if (width == 0) return formatted("  all of %zu draws are %g\n", sample.size(), low) + below;
  std::array<std::size_t, bars> counts{};
  for (double x : sample) ++counts[std::min(static_cast<std::size_t>(x / width - low / width), bars - 1)];
  const std::size_t most = *std::max_element(counts.begin(), counts.end());
  std::string result = formatted("  %zu draws\n", sample.size());
  for (std::size_t i = 0; i < bars; ++i) {
    const std::string bar(counts[i] * 50 / most, '#');
    result += formatted("  %12.5g %6zu ", low + static_cast<double>(i) * width, counts[i]) + bar + "\n";
  }
  return result + below;
}

bool verbose() {
  const char* text = std::getenv("FAIRLIGHT_VERBOSE");
  return text != nullptr && std::string(text) != "0" && *text != '\0';
}

}  // namespace

Reference bounded(double mean, double lower, double upper) {
  if (!(lower <= upper))
    throw std::invalid_argument(formatted("the range [%g, %g] is empty (give the lower end first)", lower, upper));
  return {mean, lower, upper, 0, std::abs(mean)};
}

std::vector<Reference> detail::on_sides(std::vector<Reference> references, Sides sides) {
  for (Reference& reference : references) reference.sides = sides;
  return references;
}

Expectation detail::judge(const Site& site, const Trial& trial, const std::string& claim, const Finding& finding,
                          const std::vector<double>& sample, const Wording& wording) {
  const double unit = wording.unit;
  const bool met = finding.verdict == Verdict::certified;
  std::string message = std::string(name(finding.verdict)) + ": " + claim + "\n";
  // A draw that cannot be ends a test without an estimate.
  const bool estimated = finding.interval.lo < finding.interval.hi;
  if (estimated)
    message += formatted("  bias %+.3e, in [%+.3e, %+.3e], margin %.1e, %s\n", unit * finding.bias,
                         unit * finding.interval.lo, unit * finding.interval.hi, unit * finding.margin,
                         wording.unit_name.c_str());
  message += formatted("  %llu draws, level %.1e, miss rate %.0e, ", static_cast<unsigned long long>(finding.draws),
                       trial.alpha, trial.beta);
  message += std::string(name(finding.guarantee)) + "\n";
  if (!finding.note.empty()) message += "  " + finding.note + "\n";
  if (!wording.warning.empty()) message += "  warning: " + wording.warning + "\n";
  message += histogram(sample);
  message += "  again: FAIRLIGHT_SEED=" + seed_text(trial.seed) + " " + site.replay + "\n";
  if (met && (verbose() || !wording.warning.empty())) std::fputs(message.c_str(), stdout);
  return {met, message};
}

}  // namespace fairlight

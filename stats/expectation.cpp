#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <stdexcept>

#include <fairlight/stats/expectation.h>
#include <fairlight/stats/seed.h>
#include <fairlight/stats/text.h>

namespace fairlight {
namespace {

constexpr double budget = 1e-6;
constexpr double miss_rate = 0.01;

// One seed for the whole program, so one seed replays all of it.
std::uint64_t program_seed() {
  static const std::uint64_t seed = [] {
    const char* text = std::getenv("FAIRLIGHT_SEED");
    return text == nullptr ? fresh_seed() : parse_seed(text);
  }();
  return seed;
}

// A histogram with 16 bars. Ignores NaNs and infinities, which the finding's note reports.
std::string histogram(std::vector<double> sample) {
  constexpr std::size_t bars = 16;
  std::erase_if(sample, [](double x) { return !std::isfinite(x); });
  if (sample.empty()) return {};
  const auto [least, greatest] = std::minmax_element(sample.begin(), sample.end());
  const double low = *least;
  const double width = *greatest / bars - low / bars;  // greatest - low could overflow
  if (width == 0) return formatted("  all of %zu draws are %g\n", sample.size(), low);
  std::array<std::size_t, bars> counts{};
  for (double x : sample) ++counts[std::min(static_cast<std::size_t>(x / width - low / width), bars - 1)];
  const std::size_t most = *std::max_element(counts.begin(), counts.end());
  std::string result = formatted("  %zu draws\n", sample.size());
  for (std::size_t i = 0; i < bars; ++i) {
    const std::string bar(counts[i] * 50 / most, '#');
    result += formatted("  %12.5g %6zu ", low + static_cast<double>(i) * width, counts[i]) + bar + "\n";
  }
  return result;
}

}  // namespace

Trial trial_at(const Site& site, double margin) {
  if (!(margin > 0 && margin < 1)) throw std::invalid_argument("the margin must be in (0,1) (it is relative)");
  if (site.tests == 0 || site.ordinal == 0)
    throw std::invalid_argument("a site needs its test program and its ordinal");
  const double k = std::numbers::pi * static_cast<double>(site.ordinal);
  const double share = budget / static_cast<double>(site.tests) * 6 / (k * k);
  return {site.name + "#" + std::to_string(site.ordinal), program_seed(), share, miss_rate, margin};
}

Generator generator_for(const Trial& trial, const std::string& purpose) {
  const std::string name = trial.claim + "/" + purpose;
  std::vector<std::uint32_t> words(name.begin(), name.end());
  words.push_back(static_cast<std::uint32_t>(trial.seed));
  words.push_back(static_cast<std::uint32_t>(trial.seed >> 32));
  std::seed_seq sequence(words.begin(), words.end());
  return Generator(sequence);
}

double detail::scale_of(const std::vector<double>& pilot) {
  const double mean = std::abs(Moments::of(pilot).mean());
  return std::isfinite(mean) && mean > 0 ? mean : 1;
}

Expectation detail::judge(const Site& site, const Trial& trial, const std::string& claim, const Finding& finding,
                          const std::vector<double>& sample) {
  std::string message = std::string(name(finding.verdict)) + ": " + claim + "\n";
  message += formatted("  bias %+.3e, in [%+.3e, %+.3e], margin %.1e, all relative\n", finding.bias,
                       finding.interval.lo, finding.interval.hi, finding.margin);
  message += formatted("  %llu draws, level %.1e, miss rate %.0e, ", static_cast<unsigned long long>(finding.draws),
                       trial.alpha, trial.beta);
  message += std::string(name(finding.guarantee)) + "\n";
  if (!finding.note.empty()) message += "  " + finding.note + "\n";
  message += histogram(sample);
  message += "  again: FAIRLIGHT_SEED=" + seed_text(trial.seed) + " " + site.replay + "\n";
  return {finding.verdict == Verdict::certified, message};
}

}  // namespace fairlight

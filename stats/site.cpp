#include <cstdlib>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <fairlight/stats/seed.h>
#include <fairlight/stats/site.h>

namespace fairlight {
namespace {

constexpr double budget = 1e-6;
constexpr double miss_rate = 0.01;

// One seed for a run of the whole program, so one seed replays all of it.
std::uint64_t program_seed() {
  static const std::uint64_t seed = [] {
    const char* text = std::getenv("FAIRLIGHT_SEED");
    return text == nullptr ? fresh_seed() : parse_seed(text);
  }();
  return seed;
}

// The seed of a repetition: SplitMix64 (Steele, Lea, Flood 2014) at that place. Repetition 0 has the
// program's own.
std::uint64_t seed_of(std::uint64_t repetition) {
  if (repetition == 0) return program_seed();
  std::uint64_t z = program_seed() + repetition * 0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

}  // namespace

Trial trial_at(const Site& site, double margin) {
  if (!(margin > 0 && margin < 1))
    throw std::invalid_argument("the margin must be in (0,1) (it is relative; give others by fairlight::absolute)");
  if (site.tests == 0 || site.ordinal == 0)
    throw std::invalid_argument("a site needs its test program and its ordinal");
  const double k = std::numbers::pi * static_cast<double>(site.ordinal);
  const double share = budget / static_cast<double>(site.tests) * 6 / (k * k);
  return {site.name + "#" + std::to_string(site.ordinal), seed_of(site.repetition), share, miss_rate, margin};
}

Generator generator_for(const Trial& trial, const std::string& purpose) {
  const std::string name = trial.claim + "/" + purpose;
  std::vector<std::uint32_t> words(name.begin(), name.end());
  words.push_back(static_cast<std::uint32_t>(trial.seed));
  words.push_back(static_cast<std::uint32_t>(trial.seed >> 32));
  std::seed_seq sequence(words.begin(), words.end());
  return Generator(sequence);
}

}  // namespace fairlight

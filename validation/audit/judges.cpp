#include <algorithm>
#include <cmath>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <fairlight/stats/moments.h>
#include <fairlight/validation/audit/judges.h>

// Other projects' rules, written anew. Where a statistic is NaN, the result follows from the
// direction of their comparison, which is kept.
namespace fairlight {
namespace {

using Draws = std::span<const double>;

// The level of each of n independent tests, where right code fails any of them with probability
// `level` (Sidak 1967).
double sidak(double level, std::size_t n) { return 1 - std::pow(1 - level, 1 / static_cast<double>(n)); }

// A standard deviation needs two draws: with fewer there is no test.
bool too_few(Draws draws) { return draws.size() < 2; }

// Whether the mean is 1 to within this many standard errors. Draws that are all 1 pass. The strict
// comparisons of the projects would fail them, but they were not written for constants.
bool within(Draws draws, double standard_errors) {
  const Moments moments = Moments::of(draws);
  return std::abs(moments.mean() - 1) <= standard_errors * moments.standard_error();
}

bool fails_student(Draws draws, double level) {
  if (too_few(draws)) return false;
  const Moments moments = Moments::of(draws);
  const auto n = static_cast<double>(draws.size());
  const double t = std::abs(moments.mean() - 1) * std::sqrt(n / std::max(moments.variance(), 1e-5));
  return !std::isnan(t) && 2 * cdf(complement(boost::math::students_t(n - 1), t)) < level;
}

}  // namespace

bool fails_by_pbrt(const JudgedDraws& draws) {
  double sum = 0;
  for (Draws channel : draws.channels) sum += Moments::of(channel).mean();
  return !(std::abs(sum / static_cast<double>(draws.channels.size()) - 1) <= 0.025);
}

bool fails_by_mitsuba(const JudgedDraws& draws, std::size_t pixels) {
  pixels = std::min(pixels, draws.channels[0].size());
  const std::size_t each = draws.channels[0].size() / pixels;
  const double level = sidak(0.01, pixels);
  std::size_t passed = 0;
  for (std::size_t c = 0; c < draws.channels.size(); ++c) {
    const double scale = std::sqrt(static_cast<double>(each) / std::max(draws.variances[c], 1e-4));
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
      const double z = std::abs(Moments::of(draws.channels[c].subspan(pixel * each, each)).mean() - 1) * scale;
      if (std::erfc(z / std::sqrt(2)) > level) ++passed;
    }
  }
  const auto of_a_channel = static_cast<double>(passed) / static_cast<double>(draws.channels.size());
  return of_a_channel < 0.9975 * static_cast<double>(pixels);
}

bool fails_by_nori(const JudgedDraws& draws) {
  const double level = sidak(0.01, draws.channels.size());
  return std::ranges::any_of(draws.channels, [&](Draws channel) { return fails_student(channel, level); });
}

bool fails_by_openmc(const JudgedDraws& draws) {
  const auto run_fails = [&](std::size_t run) {
    return std::ranges::any_of(draws.channels, [&](Draws channel) {
      const std::size_t half = channel.size() / 2;
      const Draws part = channel.subspan(run * half, half);
      return !too_few(part) && !within(part, 4);
    });
  };
  return run_fails(0) && run_fails(1);
}

bool fails_by_abseil(const JudgedDraws& draws, std::size_t trials) {
  constexpr double level = 0.01;
  trials = std::min(trials, draws.channels[0].size() / 2);
  if (trials == 0) return false;
  const std::size_t each = draws.channels[0].size() / trials;
  const double bound = quantile(complement(boost::math::normal(), sidak(level, trials) / 2));
  const auto allowed = std::max(1L, std::lround(std::ceil(level * static_cast<double>(trials))));
  return std::ranges::any_of(draws.channels, [&](Draws channel) {
    long failed = 0;
    for (std::size_t t = 0; t < trials; ++t) failed += within(channel.subspan(t * each, each), bound) ? 0 : 1;
    return failed > allowed;
  });
}

const std::vector<Judge>& judges() {
  static const std::vector<Judge> all{
      {"pbrt: within 0.025", fails_by_pbrt},
      {"Mitsuba: 99.75 % of pixels at 1 %", [](const JudgedDraws& draws) { return fails_by_mitsuba(draws); }},
      {"Nori: t-test at 1 %", fails_by_nori},
      {"OpenMC: 4 sigma, one rerun", fails_by_openmc},
      {"Abseil: 1 of 100 trials may fail", [](const JudgedDraws& draws) { return fails_by_abseil(draws); }},
  };
  return all;
}

}  // namespace fairlight

#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include <fairlight/estimators/concepts.h>
#include <fairlight/estimators/stream.h>
#include <fairlight/stats/law_test.h>
#include <fairlight/stats/mean_test.h>
#include <fairlight/stats/rosenblatt.h>
#include <fairlight/validation/claim.h>

namespace fairlight {

/// The checks of the registry: the tests of stats, fed by streams that depend on the trial's seed and claim alone.

/// The mean of an estimator, one reference per channel: `draw(source)` gives a double or an Rgb<double>.
template <class Draw>
Finding check_mean(const Trial& trial, const std::vector<Reference>& references, const Draw& draw) {
  const StreamKey key(trial.seed, trial.claim);
  return test_means(trial, references, [&](std::uint64_t first, std::vector<std::vector<double>>& channels) {
    for (std::size_t i = 0; i < channels[0].size(); ++i) {
      PhiloxStream<double> source(key, 0, first + i);
      const auto x = draw(source);
      if constexpr (std::is_convertible_v<decltype(x), double>) {
        channels[0][i] = x;
      } else {
        for (std::size_t c = 0; c < channels.size(); ++c) channels[c][i] = x[static_cast<Eigen::Index>(c)];
      }
    }
  });
}

/// Every draw equals the reference to within `ulps` units in the last place: an estimator without variance.
template <class Draw>
Finding check_constant(const Trial& trial, double reference, int ulps, const Draw& draw) {
  constexpr std::uint64_t draws = 100'000;
  const double tolerance = ulps * std::numeric_limits<double>::epsilon();
  const StreamKey key(trial.seed, trial.claim);
  Finding finding{.verdict = Verdict::certified, .guarantee = Guarantee::deterministic, .margin = tolerance};
  for (finding.draws = 0; finding.draws < draws; ++finding.draws) {
    PhiloxStream<double> source(key, 0, finding.draws);
    const double error = draw(source) / reference - 1;
    if (!(std::abs(error) <= std::abs(finding.bias))) finding.bias = error;
    finding.interval = {std::min(finding.interval.lo, error), std::max(finding.interval.hi, error)};
    if (std::abs(error) <= tolerance) continue;
    finding.verdict = Verdict::biased;
    finding.note =
        "draw " + std::to_string(finding.draws) + " is off by " + std::to_string(error / tolerance * ulps) + " ulp";
    return finding;
  }
  return finding;
}

/// A sampler's draws follow its density, and the density integrates to one over the domain.
template <Sampler Law, class Domain>
Finding check_law(const Trial& trial, const Law& law, const Domain& domain) {
  const StreamKey key(trial.seed, trial.claim);
  return test_law(
      trial, domain, [&](const typename Law::Point& x) { return law.pdf(x).value(); },
      [&](std::uint64_t i) {
        PhiloxStream<double> source(key, 0, i);
        return typename Law::Point(law.sample(next_pair<double>(source)));
      });
}

/// The same by bounded moments of the Rosenblatt transform: exact, and blind to fine waves.
template <Sampler Law, class Domain>
Finding check_law_moments(const Trial& trial, const Law& law, const Domain& domain) {
  const StreamKey key(trial.seed, trial.claim);
  return test_rosenblatt(
      trial, [&](double s, double t) { return law.pdf(domain.at(s, t)).value() * domain.size(); },
      [&](std::uint64_t i) {
        PhiloxStream<double> source(key, 0, i);
        return domain.coordinates(law.sample(next_pair<double>(source)));
      });
}

}  // namespace fairlight

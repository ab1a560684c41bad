#include <cmath>
#include <numbers>

#include <fairlight/stats/text.h>
#include <fairlight/validation/checks/direction_expectations.h>
#include <fairlight/validation/checks/identity.h>

namespace fairlight {
namespace {

// A uniform direction.
Vec3<double> any_direction(Generator& generator) {
  const double z = 2 * uniform(generator) - 1, angle = 2 * std::numbers::pi * uniform(generator);
  const double r = std::sqrt((1 - z) * (1 + z));
  return {r * std::cos(angle), r * std::sin(angle), z};
}

PartFinding distances_agree(const Trial& trial, std::size_t dimensions, const DistancesOfLight& distances,
                            double rounding) {
  Identity distance{"distance", "a ray in a sampled direction meets the light at the sample's distance"};
  Generator generator = generator_for(trial, "distances");
  std::vector<double> u(dimensions);
  for (int i = 0; i < identity_draws; ++i) {
    for (double& x : u) x = uniform(generator);
    const auto both = distances(u);
    if (!both) continue;
    const auto& [sampled, hit] = *both;
    distance.see(gap_between(sampled, hit), [&] {
      return formatted("the sample is at %g, the ray meets the light at %g, from ", sampled, hit) + text_of(u);
    });
  }
  return finding_of(trial, distance, rounding);
}

PartFinding is_reciprocal(const Trial& trial, const PhaseFunctionUnderTest& phase, double rounding) {
  Identity reciprocity{"reciprocity", "the phase function is the same with both directions exchanged"};
  Generator generator = generator_for(trial, "reciprocity");
  for (int i = 0; i < identity_draws; ++i) {
    const Vec3<double> out = any_direction(generator), in = any_direction(generator);
    const double there = phase.pdf(out, in), back = phase.pdf(in, out);
    reciprocity.see(gap_between(there, back),
                    [&] { return formatted("%g and %g at ", there, back) + text_of(out) + " and " + text_of(in); });
  }
  return finding_of(trial, reciprocity, rounding);
}

}  // namespace

Expectation expect_directions(const Site& site, const DirectionsUnderTest& law, const DirectionTerms& terms) {
  const Trial trial = trial_at(site, terms.margin);
  return expectation_of(site, trial, check_directions(trial, law, terms));
}

Expectation expect_light(const Site& site, const DirectionsUnderTest& law, const DistancesOfLight& distances,
                         const DirectionTerms& terms) {
  const Trial trial = trial_at(site, terms.margin);
  std::vector<PartFinding> findings = check_directions(trial, law, terms);
  findings.push_back(distances_agree(trial, law.dimensions, distances, terms.rounding));
  return expectation_of(site, trial, findings);
}

Expectation expect_phase_function(const Site& site, const PhaseFunctionUnderTest& phase,
                                  const DirectionTerms& terms) {
  const Trial trial = trial_at(site, terms.margin);
  require_terms(phase.dimensions, terms.rounding);
  std::vector<PartFinding> findings{is_reciprocal(trial, phase, terms.rounding)};
  Generator generator = generator_for(trial, "directions");
  for (int i = 0; i < 3; ++i) {
    const Vec3<double> out = any_direction(generator);
    Trial part = trial;
    part.alpha = trial.alpha / 3;
    part.claim += formatted("/%d", i);
    const DirectionsUnderTest view{phase.dimensions,
                                   [&](const std::vector<double>& u) { return phase.sample(out, u); },
                                   [&](const Vec3<double>& in) { return phase.pdf(out, in); }};
    for (PartFinding& finding : check_directions(part, view, terms)) {
      finding.statement += formatted(" (out = %s)", text_of(out).c_str());
      findings.push_back(std::move(finding));
    }
  }
  return expectation_of(site, trial, findings);
}

}  // namespace fairlight

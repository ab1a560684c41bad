#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fairlight/validation/run/components.h>
#include <fairlight/validation/run/registry.h>

namespace fairlight {
namespace {

bool tests(const Claim& claim, const std::string& component) {
  return claim.adds_up && std::ranges::find(claim.subjects, component) != claim.subjects.end();
}

Verdict verdict_of(const CommonBias& bias, double alpha, double beta) {
  if (bias.biased(alpha)) return Verdict::biased;
  return std::isinf(bias.excluded(beta)) ? Verdict::undecided : Verdict::certified;
}

}  // namespace

std::vector<std::string> components_of_registry(const std::string& instructions) {
  std::map<std::string, int> claims;
  for (const Claim& claim : registry(instructions)) {
    if (!claim.adds_up) continue;
    for (const std::string& subject : std::set(claim.subjects.begin(), claim.subjects.end())) ++claims[subject];
  }
  std::vector<std::string> components;
  for (const auto& [subject, number] : claims) {
    if (number > 1) components.push_back(subject);
  }
  return components;
}

double component_level(const RunOptions& run_options) {
  return manifest_of(run_options).joint_level(components_of_registry(run_options.instructions.front()).size());
}

CommonBias common_bias(const std::string& component, const std::string& instructions,
                       const std::vector<const Claim*>& claims, const EvidenceOf& evidence) {
  CommonBias bias;
  for (const Claim* claim : claims) {
    if (tests(*claim, component) && claim->instructions == instructions) bias.add(evidence(*claim));
  }
  return bias;
}

std::vector<ComponentOutcome> component_outcomes(const std::vector<Outcome>& outcomes,
                                                 const RunOptions& run_options) {
  std::vector<const Claim*> claims;
  std::map<const Claim*, const Outcome*> of_claim;
  std::set<std::string> sets;
  for (const Outcome& outcome : outcomes) {
    claims.push_back(outcome.claim);
    of_claim[outcome.claim] = &outcome;
    sets.insert(outcome.claim->instructions);
  }
  const auto evidence = [&](const Claim& claim) { return EvidenceSum(of_claim.at(&claim)->evidence.margin_grid); };
  const double alpha = component_level(run_options), beta = run_options.terms.beta;
  std::vector<ComponentOutcome> components;
  for (const std::string& name : components_of_registry(run_options.instructions.front())) {
    for (const std::string& set : sets) {
      const CommonBias bias = common_bias(name, set, claims, evidence);
      if (bias.claims() < 2) continue;
      components.push_back(
          {name, set, bias.claims(), verdict_of(bias, alpha, beta), bias.upward(), bias.excluded(beta)});
    }
  }
  return components;
}

Verdict overall(const std::vector<Outcome>& outcomes, const std::vector<ComponentOutcome>& components) {
  const bool one_biased = std::ranges::any_of(
      components, [](const ComponentOutcome& component) { return component.verdict == Verdict::biased; });
  return one_biased ? Verdict::biased : overall(outcomes);
}

}  // namespace fairlight

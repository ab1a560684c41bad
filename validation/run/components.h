#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <fairlight/stats/common_bias.h>
#include <fairlight/validation/run/run_claims.h>

namespace fairlight {

/// What the claims of one component show together: the means of all of them may be too high, or all
/// too low, by less than any claim alone can tell. Claims whose evidence does not add up take no
/// part: laws, constants, differences, one-sided claims.
struct ComponentOutcome {
  std::string name;          ///< the subject of the claims, a type name
  std::string instructions;  ///< the instruction set of their packets
  std::size_t claims;        ///< how many add up, of those that ran
  Verdict verdict;           ///< undecided if no margin is certified
  bool upward;               ///< if biased: whether the means are too high
  double margin;             ///< the finest common bias that is excluded; infinity if none is
  std::optional<Standing> ledger{};
};

/// The components that have two claims or more that add up, in the registry.
std::vector<std::string> components_of_registry(const std::string& instructions);

/// The level of one component in a run, whatever else runs.
double component_level(const RunOptions& run_options);

/// What is known of a claim, or nothing if it has no evidence.
using EvidenceOf = std::function<EvidenceSum(const Claim&)>;

/// The joint evidence of the claims of a component among `claims`, from the first to the last.
CommonBias common_bias(const std::string& component, const std::string& instructions,
                       const std::vector<const Claim*>& claims, const EvidenceOf& evidence);

/// The outcomes of all components of which two claims or more have evidence, by name.
std::vector<ComponentOutcome> component_outcomes(const std::vector<Outcome>& outcomes,
                                                 const RunOptions& run_options);

/// The worst verdict of all claims, or `biased` if a component is.
Verdict overall(const std::vector<Outcome>& outcomes, const std::vector<ComponentOutcome>& components);

}  // namespace fairlight

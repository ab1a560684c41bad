#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <fairlight/stats/verdict.h>

namespace fairlight {

/// What a check is given: its own random numbers, its share of the false alarms, and what it must show.
struct Trial {
  std::string claim;  ///< the purpose of its random numbers, so that no two claims share any
  std::uint64_t seed;
  double alpha;   ///< level: the probability of a false alarm on right code
  double beta;    ///< miss rate: the probability that a bias of the margin is certified
  double margin;  ///< the bias to exclude, relative to the reference
};

/// One row of the registry: something that is claimed of the kit, and how it is checked.
struct Claim {
  std::string name;                   ///< dotted: what.how.claim
  std::string kind;                   ///< law | mean | constant | agreement
  std::vector<std::string> subjects;  ///< the components that it is about, by their type's name
  std::string statement;              ///< in words, for a reader
  std::string source;                 ///< where the answer comes from
  double margin_factor;               ///< its margin, in units of the run's: 1, or more where 1 would take too long
  std::function<Finding(const Trial&)> check;
  double weight = 1;  ///< its share of the budget is weight / the sum of all weights
};

}  // namespace fairlight

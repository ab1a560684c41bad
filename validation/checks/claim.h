#pragma once

#include <functional>
#include <string>
#include <vector>

#include <fairlight/stats/manifest.h>
#include <fairlight/stats/verdict.h>

namespace fairlight {

/// One row of the registry: something that is claimed of the kit, and how it is checked.
struct Claim {
  std::string name;                   ///< dotted: what.how.claim
  std::string kind;                   ///< law | mean | constant | agreement | second order
  std::vector<std::string> subjects;  ///< the components that it is about, by their type's name
  std::string statement;              ///< in words, for a reader
  std::string source;                 ///< where the answer comes from
  double margin_factor;               ///< its margin, in units of the run's: 1, or more where 1 would take too long
  std::function<Finding(const Trial&)> check;
  std::string real = "double";  ///< the arithmetic: double | packet
  double finest_margin = 0;     ///< its margin where the run's is finer than its roundings allow
  double weight = 1;            ///< its share of the budget is weight / the sum of all weights
  std::string file{};           ///< of claims/, where it is made; the registry fills it in
  std::string instructions{};   ///< the instruction set of its packets; the registry fills it in
};

}  // namespace fairlight

#pragma once

#include <functional>
#include <string>
#include <vector>

#include <fairlight/render/strategy_table.h>
#include <fairlight/stats/manifest.h>
#include <fairlight/stats/verdict.h>
#include <fairlight/validation/checks/parameter_range.h>

namespace fairlight {

/// One row of the registry: a statement about an estimator, and how it is checked.
struct Claim {
  std::string name;                   ///< dotted, for example "roulette.integral.packet"
  std::string kind;                   ///< law | mean | constant | agreement | second order | variance | streams
  std::vector<std::string> subjects;  ///< the components that it tests, by their type names
  std::string statement;              ///< the statement in words
  std::string source;                 ///< where the reference comes from
  double margin_factor;  ///< its margin is this times the run's: 1, or more where 1 would take too long
  std::function<Finding(const Trial&)> check;
  std::string real = name_of(Arithmetic::doubles);  ///< the name of its arithmetic
  double finest_margin = 0;  ///< the finest margin that its rounding allows: the floor of its margin; 0 means none
  double weight = 1;         ///< its share of the budget is weight / the sum of all weights
  /// Whether its bias is relative to a positive reference and tested on both sides, so that biases of
  /// its subjects add up over their claims; see CommonBias.
  bool adds_up = false;
  std::vector<ParameterRange> covers{};  ///< the parameters that each run draws anew
  std::string file{};                    ///< the file in claims/ that makes it; the registry fills it in
  std::string instructions{};            ///< the instruction set of its packets; the registry fills it in
};

}  // namespace fairlight

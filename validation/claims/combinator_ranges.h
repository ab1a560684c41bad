#pragma once

#include <string>
#include <vector>

#include <fairlight/validation/claims/signed_polynomials.h>

namespace fairlight {

/// The parameters of the rows over whole domains of combinators.

/// Those of n polynomials, and more.
inline std::vector<ParameterRange> polynomials_and(const std::string& component, std::size_t n,
                                                   const std::vector<ParameterRange>& more) {
  std::vector<ParameterRange> ranges = polynomial_ranges(component, n);
  ranges.insert(ranges.end(), more.begin(), more.end());
  return ranges;
}

/// Less than a run, one, some, and fractions of a run.
inline std::vector<ParameterRange> few_runs() {
  const auto k = [](double low, double high) {
    return ParameterRange{"Splitting", "k", low, high, ParameterRange::Law::logarithmic};
  };
  return polynomials_and("Splitting", 6, {k(0.25, 0.25), k(0.02, 1), k(1, 1), k(2.25, 2.25), k(3, 3), k(1, 8)});
}
inline std::vector<ParameterRange> many_runs() {
  return polynomials_and("Splitting", 2, {{"Splitting", "k", 64, 64}, {"Splitting", "k", 8, 64}});
}

/// Rare, any, nearly certain and certain.
inline std::vector<ParameterRange> survival_probabilities() {
  return polynomials_and("Rouletted", 4,
                         {{"Rouletted", "q", 1e-3, 0.1, ParameterRange::Law::logarithmic},
                          {"Rouletted", "q", 0.1, 0.97},
                          {"Rouletted", "q", 0.97, 1},
                          {"Rouletted", "q", 1, 1}});
}

inline std::vector<ParameterRange> grids() {
  return polynomials_and("StratifiedMean", 4,
                         {{"StratifiedMean", "columns", 1, 10}, {"StratifiedMean", "rows", 1, 10}});
}

inline std::vector<ParameterRange> control_factors() {
  return polynomials_and(
      "ControlVariate", 6,
      {{"ControlVariate", "c", -2, -0.5}, {"ControlVariate", "c", -0.5, 0.5}, {"ControlVariate", "c", 0.5, 2}});
}

inline std::vector<ParameterRange> faint_ranges(const std::string& component) {
  return {{component, "size of the terms", 0, 1}};
}

}  // namespace fairlight

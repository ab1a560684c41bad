#pragma once

#include <functional>
#include <string>
#include <vector>

#include <fairlight/stats/manifest.h>
#include <fairlight/stats/verdict.h>

namespace fairlight {

/// A statistical test on draws of a known law, to measure its false alarms and misses.
struct TestKind {
  std::string name;
  bool one_sided;  ///< only a positive bias is a fault

  /// Runs the test with the seed of the trial. `bias` is relative to the reference: 0 for right
  /// code, +margin and -margin for the biases that the test must not certify.
  std::function<Finding(const Trial& trial, double bias)> run;

  /// Whether wrong code is `biased`. Without a range no draws show that, and it must be `undecided`.
  bool refutes = true;
};

/// Every kind of test in stats/, at least once each.
const std::vector<TestKind>& test_kinds();

/// A law of mean 1 to measure the cost of the core test: its draw from one uniform number, its
/// squared coefficient of variation, and a range with the tail slack that the margin needs.
struct CostLaw {
  std::string name;
  double cv2;
  double margin;  ///< for which the cost is measured
  double upper;
  double tail_slack;
  double limit;  ///< the most draws on right code, in units of cv2 / margin^2; 0 where it is only reported
  std::function<double(double u)> draw;
};

const std::vector<CostLaw>& cost_laws();

/// The core test on a law, with every draw multiplied by 1 + bias.
Finding bet_on(const CostLaw& law, const Trial& trial, double bias);

}  // namespace fairlight

#pragma once

#include <functional>
#include <string>
#include <vector>

#include <fairlight/stats/manifest.h>
#include <fairlight/stats/verdict.h>

namespace fairlight {

/// A statistical test on draws of a law that is known, to see what it says of them.
struct TestKind {
  std::string name;
  bool one_sided;  ///< only a bias above is a fault

  /// Runs the test with the trial's seed. `bias` is relative to the reference: 0 for right code, +margin and
  /// -margin for the biases that the test must not certify.
  std::function<Finding(const Trial& trial, double bias)> run;
};

/// Every kind of test that stats has, each at least once.
const std::vector<TestKind>& test_kinds();

/// A law of mean 1 on which the core test's cost is measured: its draws from one uniform number, its squared
/// coefficient of variation, and a range with the slack that its tail needs at the given margin.
struct CostLaw {
  std::string name;
  double cv2;
  double margin;  ///< at which the cost is measured
  double upper;
  double tail_slack;
  double
      limit;  ///< draws per cv2 / margin^2 that the core test may take on right code; 0 where it is only reported
  std::function<double(double u)> draw;
};

const std::vector<CostLaw>& cost_laws();

/// The core test on a law, with every draw multiplied by 1 + bias.
Finding bet_on(const CostLaw& law, const Trial& trial, double bias);

}  // namespace fairlight

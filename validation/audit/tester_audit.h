#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <fairlight/render/render_image.h>
#include <fairlight/validation/audit/test_kinds.h>

namespace fairlight {

/// The options of an audit of the tests.
struct TesterAudit {
  std::uint64_t seed;
  int threads;
  int calibration_runs = 3000;
  int power_seeds = 300;
  int cost_runs = 200;
  int p_values = 10000;
};

/// How often a test gave a wrong verdict.
struct TesterOutcome {
  std::string name;
  int runs;
  int failures;
  int limit;  ///< the largest number of failures that chance allows, at 1e-6 for all rows together; or 0
  bool passed() const { return failures <= limit; }
};

/// The smallest limit that a binomial count exceeds with a probability of at most 1e-8.
int binomial_limit(int runs, double probability);

/// Calibration: runs every kind of test on right code at alpha = 0.01, which is 10^4 times the
/// budget of a run. A failure is any verdict but `certified`.
std::vector<TesterOutcome> audit_calibration(const TesterAudit& audit, const Progress& progress = {});

/// Power: runs every kind of test on draws that are off by plus and minus the margin, at two miss
/// rates. At 1e-8 no run may miss (limit 0). At 0.01, the usual one, the misses must stay within
/// the binomial limit for that rate. A miss is any verdict but `biased`, or but `undecided` of a test
/// that needs a range to refute.
std::vector<TesterOutcome> audit_power(const TesterAudit& audit, const Progress& progress = {});

/// The cost of the core test on right code, at alpha = 1e-8 and beta = 0.01, in units of (CV /
/// margin)^2 draws.
struct CostOutcome {
  std::string law;
  double draws_per_cv2;   ///< the mean over runs
  double standard_error;  ///< of that mean
  double limit;           ///< 0 where the cost is only reported
};
std::vector<CostOutcome> audit_cost(const TesterAudit& audit, const Progress& progress = {});

/// The number of draws of a z-test of fixed size with this level and miss rate, (z_(alpha/2) +
/// z_beta)^2, in the same unit.
double fixed_size_cost(double alpha, double beta);

/// Checks of p-values of tests of fixed size. Those of right tests must be uniform, at a level of
/// 1e-6. Those of a test whose sigma is 5 % too small must not be, at a level of 1e-3.
struct UniformityOutcome {
  std::string name;
  int p_values;
  double least;   ///< the smallest p-value of the three statistics
  bool expected;  ///< whether uniformity is expected
  bool uniform;
};
std::vector<UniformityOutcome> audit_uniformity(const TesterAudit& audit);

}  // namespace fairlight

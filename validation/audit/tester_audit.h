#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <fairlight/render/render_image.h>
#include <fairlight/validation/audit/test_kinds.h>

namespace fairlight {

/// How the tester is tested.
struct TesterAudit {
  std::uint64_t seed;
  int threads;
  int calibration_runs = 3000;
  int power_seeds = 300;
  int cost_runs = 200;
  int p_values = 10000;
};

/// How often a test failed where it should not have.
struct TesterOutcome {
  std::string name;
  int runs;
  int failures;
  int limit;  ///< the largest number of failures that chance allows, at 1e-6 for all rows together, by the binomial law; or 0
  bool passed() const { return failures <= limit; }
};

/// Calibration: every kind of test on right code at alpha = 0.01, 10^4 times the budget of a run; a failure is any
/// verdict but `certified`.
std::vector<TesterOutcome> audit_calibration(const TesterAudit& audit, const Progress& progress = {});

/// Power: every kind of test on draws that are off by plus and minus the margin, twice. With a miss rate of 1e-8 no
/// run may miss (limit 0); with 0.01, the usual one, misses are inside the binomial limit of that rate. A miss is
/// any verdict but `biased`.
std::vector<TesterOutcome> audit_power(const TesterAudit& audit, const Progress& progress = {});

/// The core test's cost on right code, at alpha = 1e-8 and beta = 0.01, in units of (CV / margin)^2 draws.
struct CostOutcome {
  std::string law;
  double draws_per_cv2;   ///< the mean over runs
  double standard_error;  ///< of that mean
  double limit;           ///< 0 where the cost is only reported
};
std::vector<CostOutcome> audit_cost(const TesterAudit& audit, const Progress& progress = {});

/// What a z-test of fixed size takes to do both, (z_(alpha/2) + z_beta)^2, in the same unit.
double fixed_size_cost(double alpha, double beta);

/// Fixed-n p-values: those of right tests must be uniform, judged at 1e-6, and those of a test whose sigma is 5 % too
/// small must not be, judged at 1e-3.
struct UniformityOutcome {
  std::string name;
  int p_values;
  double least;   ///< the least of the three statistics' p-values
  bool expected;  ///< whether uniformity is expected
  bool uniform;
};
std::vector<UniformityOutcome> audit_uniformity(const TesterAudit& audit);

}  // namespace fairlight

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <fairlight/stats/evidence_sum.h>

namespace fairlight {

/// log(mean(exp(x))) of at least one number; an infinite number makes it infinite.
double log_mean_exp(std::span<const double> logs);

/// What independent claims show together of a relative bias that is common to them. The product of
/// e-values of independent claims is an e-value, at any times at which the claims have stopped.
/// Guarantee: if no claim is biased, `biased` with probability at most alpha. If each claim has a
/// channel that is too high by x or more, or each has one that is too low by that, `excluded` is at
/// most x with probability at most beta. Biases of different signs need not add up.
/// Source   Vovk and Wang 2021, "E-values: calibration, combination and applications"
class CommonBias {
 public:
  CommonBias() : total_(margin_levels, Wealth{}) {}

  /// Adds a claim that is independent of those before, and tested on both sides. Its channels may
  /// depend on each other: their mean is an e-value against a right claim, and their smallest is one
  /// against a channel that is off.
  void add(const EvidenceSum& claim);

  std::size_t claims() const { return claims_; }

  /// Whether the mixture of all levels and of both signs reaches 1/alpha.
  bool biased(double alpha) const { return joint().biased(alpha); }

  /// Whether more speaks for a bias upwards than for one downwards.
  bool upward() const;

  /// The finest common relative bias that is excluded, on both sides; infinite if there is none.
  double excluded(double beta) const { return joint().certified_margin(beta); }

 private:
  EvidenceSum joint() const;

  std::size_t claims_ = 0;
  std::vector<Wealth> total_;  // the sums of log wealths, by level
};

}  // namespace fairlight

#pragma once

#include <cstddef>
#include <vector>

namespace fairlight {

/// The probability of a false alarm in one whole run, shared out among its claims by Bonferroni's inequality, which
/// holds however the claims depend on each other.
/// A share depends on the whole list alone: choosing a subset to run never changes it.
class Budget {
 public:
  /// total in (0,1); weights positive and finite, at least one. Throws std::invalid_argument otherwise.
  Budget(double total, const std::vector<double>& weights);

  double total() const { return total_; }
  /// alpha_i = total * w_i / sum(w). Throws std::out_of_range for a claim that is not on the list.
  double share(std::size_t claim) const { return shares_.at(claim); }

 private:
  double total_;
  std::vector<double> shares_;
};

}  // namespace fairlight

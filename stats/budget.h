#pragma once

#include <cstddef>
#include <vector>

namespace fairlight {

/// The probability of a false alarm in a run of all claims, divided among the claims. By
/// Bonferroni's inequality the total holds however the claims depend on each other. A share depends
/// on the whole list: running a subset does not change it.
class Budget {
 public:
  /// total in (0,1); at least one weight, all positive and finite. Throws std::invalid_argument
  /// otherwise.
  Budget(double total, const std::vector<double>& weights);

  double total() const { return total_; }
  /// alpha_i = total * w_i / sum(w). Throws std::out_of_range for a claim that is not on the list.
  double share(std::size_t claim) const { return shares_.at(claim); }

 private:
  double total_;
  std::vector<double> shares_;
};

}  // namespace fairlight

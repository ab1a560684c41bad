#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace fairlight {

/// Estimates how much of a run is done, in time, from the seconds that each part has spent and
/// still needs. It expects parts that have not begun to be like the others.
class Forecast {
 public:
  explicit Forecast(std::size_t parts) : spent_(parts), left_(parts), begun_(parts, false) {}

  void set(std::size_t part, double spent, double left) {
    spent_[part] = spent;
    left_[part] = left;
    begun_[part] = true;
  }

  double left(std::size_t part) const { return left_[part]; }

  /// The share of all seconds that is spent, in [0,1].
  double done() const {
    const double spent = std::accumulate(spent_.begin(), spent_.end(), 0.0);
    const double left = std::accumulate(left_.begin(), left_.end(), 0.0);
    const auto begun = static_cast<double>(std::count(begun_.begin(), begun_.end(), true));
    return spent > 0 ? spent / (spent + left) * begun / static_cast<double>(begun_.size()) : 0;
  }

 private:
  std::vector<double> spent_, left_;
  std::vector<bool> begun_;
};

}  // namespace fairlight

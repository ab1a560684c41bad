#include <cmath>
#include <numeric>
#include <stdexcept>

#include <fairlight/stats/budget.h>

namespace fairlight {

Budget::Budget(double total, const std::vector<double>& weights) : total_(total) {
  if (!(total > 0 && total < 1)) throw std::invalid_argument("the budget must be in (0,1) (it is a probability)");
  if (weights.empty()) throw std::invalid_argument("the budget has no claims (there is nothing to share it among)");
  for (double weight : weights) {
    if (!(weight > 0 && std::isfinite(weight))) {
      throw std::invalid_argument("a claim's weight must be positive and finite (its share would be none or all)");
    }
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double weight : weights) shares_.push_back(total * weight / sum);
}

}  // namespace fairlight

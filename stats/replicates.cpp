#include <cmath>
#include <stdexcept>

#include <fairlight/stats/replicates.h>

namespace fairlight {

double convergence_exponent(std::span<const std::pair<double, double>> variances) {
  if (variances.size() < 2) throw std::invalid_argument("an exponent needs at least two sizes");
  double x = 0;
  double y = 0;
  double xx = 0;
  double xy = 0;
  for (const auto& [n, variance] : variances) {
    if (!(n > 0 && variance > 0)) throw std::invalid_argument("sizes and variances must be positive");
    x += std::log(n);
    y += std::log(variance);
    xx += std::log(n) * std::log(n);
    xy += std::log(n) * std::log(variance);
  }
  const auto count = static_cast<double>(variances.size());
  return -(count * xy - x * y) / (count * xx - x * x);
}

}  // namespace fairlight

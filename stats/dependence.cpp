#include <cmath>
#include <numeric>

#include <fairlight/stats/dependence.h>
#include <fairlight/stats/text.h>

namespace fairlight {

void LagOne::add(std::span<const double> draws) {
  if (draws.empty()) return;
  const double sum = std::accumulate(draws.begin(), draws.end(), 0.0);
  const auto before = static_cast<double>(count_), n = static_cast<double>(draws.size());
  mean_ = (before * mean_ + sum) / (before + n);
  double last = count_ == 0 ? 0 : last_ - mean_;
  for (double draw : draws) {
    const double x = draw - mean_, product = x * last;
    squares_ += x * x;
    products_ += product;
    squared_products_ += product * product;
    last = x;
  }
  last_ = draws.back();
  count_ += draws.size();
}

double LagOne::correlation() const { return products_ / squares_; }

std::string LagOne::warning() const {
  constexpr double least = 0.05, standard_errors = 6;
  constexpr std::uint64_t fewest = 100;
  if (count_ < fewest) return {};
  const double rounding = 1e-12 * mean_;
  if (squares_ <= static_cast<double>(count_) * rounding * rounding) return {};  // a constant
  const double r = correlation();
  if (!(std::abs(r) > least && std::abs(products_) > standard_errors * std::sqrt(squared_products_))) return {};
  return formatted(
      "the draws depend on each other: each has correlation %+.2f with the next, which voids the verdict (make "
      "each draw an independent replicate)",
      r);
}

}  // namespace fairlight

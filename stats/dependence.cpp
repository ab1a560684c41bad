#include <cmath>

#include <fairlight/stats/dependence.h>
#include <fairlight/stats/text.h>

namespace fairlight {

void LagOne::add(std::span<const double> draws) {
  if (draws.empty()) return;
  if (count_ == 0) first_ = last_ = draws[0];
  double last = last_ - first_;
  for (double draw : draws) {
    const double x = draw - first_;
    sum_ += x;
    squares_ += x * x;
    products_ += x * last;
    last = x;
  }
  last_ = draws.back();
  count_ += draws.size();
}

double LagOne::correlation() const {
  const auto n = static_cast<double>(count_);
  const double mean = sum_ / n;
  return (products_ / n - mean * mean) / (squares_ / n - mean * mean);
}

std::string LagOne::warning() const {
  constexpr double least = 0.05, standard_errors = 6;
  if (count_ < 1000) return {};
  const double r = correlation();
  if (!(std::abs(r) > least && std::abs(r) * std::sqrt(static_cast<double>(count_)) > standard_errors)) return {};
  return formatted(
      "draws depend on each other: each has correlation %+.2f with the next (make one draw of each "
      "independent replicate)",
      r);
}

}  // namespace fairlight

#include <algorithm>
#include <cmath>
#include <limits>

#include <fairlight/stats/arms.h>
#include <fairlight/stats/betting_test.h>

namespace fairlight {

void Arms::add(std::size_t arm, std::uint64_t first, std::span<const double> draws) {
  const Moments block = Moments::of(draws);
  if (!std::isfinite(block.minimum()) || !std::isfinite(block.maximum())) {
    const auto bad = std::find_if(draws.begin(), draws.end(), [](double x) { return !std::isfinite(x); });
    throw BadDraw(first + static_cast<std::uint64_t>(bad - draws.begin()), *bad, "not a finite number");
  }
  moments_[arm].merge(block);
  scores_[arm].add(draws);
}

double Arms::difference() const { return moments_[0].mean() - (size() > 1 ? moments_[1].mean() : 0); }

double Arms::squared_error() const {
  double sum = 0;
  for (const Moments& m : moments_) sum += m.variance() / static_cast<double>(m.count());
  return sum;
}

double Arms::degrees() const {
  double sum = 0;
  for (const Moments& m : moments_) {
    const double part = m.variance() / static_cast<double>(m.count());
    sum += part * part / static_cast<double>(m.count() - 1);
  }
  return squared_error() * squared_error() / sum;
}

double Arms::skewness_of_mean() const {
  double third = 0;
  for (const Moments& m : moments_) {
    const auto n = static_cast<double>(m.count());
    third += std::abs(m.skewness()) * std::pow(m.variance(), 1.5) / (n * n);
  }
  return third / std::pow(squared_error(), 1.5);
}

double Arms::variance_of_variance() const {
  double largest = 0;
  for (const Moments& m : moments_) largest = std::max(largest, m.variance_of_variance());
  return largest;
}

bool Arms::heavy() const {
  constexpr double least_slope = 3;  // of a density; see LargestScores::slope
  return std::ranges::any_of(
      scores_, [](const LargestScores& s) { return s.slope() < least_slope && s.slope(50) < least_slope; });
}

bool Arms::constant(double scale) const {
  const double rounding = 16 * std::numeric_limits<double>::epsilon() * scale;
  return std::ranges::all_of(moments_, [=](const Moments& m) { return m.maximum() - m.minimum() <= rounding; });
}

}  // namespace fairlight

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fairlight/stats/kolmogorov_smirnov.h>

namespace fairlight {
namespace {

// The limit of P(sqrt(n) D <= x), by one series for small x and another for large x, where each
// converges fast.
double limiting_law(double x) {
  constexpr double pi = std::numbers::pi;
  double sum = 0;
  if (x > 1) {
    for (int k = 1; k < 10; ++k) sum += (k % 2 == 1 ? 2 : -2) * std::exp(-2 * k * k * x * x);
    return 1 - sum;
  }
  for (int k = 1; k < 40; k += 2) sum += std::exp(-k * k * pi * pi / (8 * x * x));
  return std::min(1.0, std::sqrt(2 * pi) / x * sum);
}

}  // namespace

KolmogorovSmirnov kolmogorov_smirnov(std::span<double> numbers) {
  if (numbers.empty()) throw std::invalid_argument("a distribution function needs at least one number");
  if (!std::all_of(numbers.begin(), numbers.end(), [](double x) { return x >= 0 && x <= 1; })) {
    throw std::invalid_argument("numbers that should be uniform must lie in [0,1]");
  }
  std::sort(numbers.begin(), numbers.end());
  const auto n = static_cast<double>(numbers.size());
  double distance = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto below = static_cast<double>(i);
    distance = std::max({distance, (below + 1) / n - numbers[i], numbers[i] - below / n});
  }
  const double root = std::sqrt(n);
  return {distance, std::min(1.0, 2 * std::exp(-2 * n * distance * distance)),
          limiting_law((root + 0.12 + 0.11 / root) * distance)};
}

}  // namespace fairlight

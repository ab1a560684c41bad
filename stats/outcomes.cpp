#include <algorithm>
#include <cmath>

#include <boost/math/distributions/binomial.hpp>

#include <fairlight/stats/outcomes.h>

namespace fairlight {
namespace {

constexpr double rarest = 1e-7;
constexpr double frequent = 80;  // expected draws, from which chi-square is right (chi_square.h)

double scale_of(double probability) { return std::sqrt(std::max(probability, rarest)); }

}  // namespace

CellTails cell_tails(std::uint64_t count, double draws, double probability) {
  if (probability == 0) return {1, count == 0 ? 1.0 : 0.0};
  if (probability >= 1) return {static_cast<double>(count) < draws ? 0.0 : 1.0, 1};
  const boost::math::binomial law(draws, probability);
  const auto k = static_cast<double>(count);
  return {cdf(law, k), k > 0 ? cdf(complement(law, k - 1)) : 1};
}

OutcomeBounds bound_rare_outcomes(std::span<const std::uint64_t> counts, std::span<const double> probabilities,
                                  double draws, double beta, bool all) {
  using boost::math::binomial;
  OutcomeBounds bounds{0, 0};
  const double level = beta / (2 * static_cast<double>(counts.size()));
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double p = probabilities[i];
    if (!all && draws * p >= frequent) continue;
    const auto k = static_cast<double>(counts[i]);
    const double low = binomial::find_lower_bound_on_p(draws, k, level);
    const double high = binomial::find_upper_bound_on_p(draws, k, level);
    bounds.estimate = std::max(bounds.estimate, std::abs(k / draws - p) / scale_of(p));
    bounds.deviation = std::max(bounds.deviation, std::max(p - low, high - p) / scale_of(p));
  }
  return bounds;
}

// The count of a right law is within 11.5 standard deviations and 66 of what is expected, at levels
// of 1e-13 for the count and 1e-5 for its bound; an impossible outcome has the count 0.
double draws_for_outcomes(std::span<const double> probabilities, double margin, double draws) {
  for (double p : probabilities) {
    const double room = margin * scale_of(p);
    if (p == 0) draws = std::max(draws, 20 / room);
    if (p > 0 && draws * p < frequent) {
      draws = std::max(draws, 66 / room);
      if (p >= rarest) draws = std::max(draws, 8 / p);
      draws = std::max(draws, (66 + 11.5 * std::sqrt(draws * p)) / room);
    }
  }
  return std::ceil(draws);
}

}  // namespace fairlight

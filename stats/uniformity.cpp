#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <boost/math/distributions/chi_squared.hpp>

#include <fairlight/stats/kolmogorov_smirnov.h>
#include <fairlight/stats/uniformity.h>

namespace fairlight {
namespace {

double two_sided(double statistic, std::size_t n) {
  const boost::math::chi_squared law(2 * static_cast<double>(n));
  return std::min(1.0, 2 * std::min(cdf(law, statistic), cdf(complement(law, statistic))));
}

}  // namespace

Uniformity uniformity(std::span<double> p_values, double alpha) {
  double small = 0;
  double large = 0;
  for (double p : p_values) {
    if (!(p > 0 && p < 1)) throw std::invalid_argument("a p-value must lie in (0,1)");
    small -= 2 * std::log(p);
    large -= 2 * std::log1p(-p);
  }
  const KolmogorovSmirnov distance = kolmogorov_smirnov(p_values);
  Uniformity result{two_sided(small, p_values.size()), two_sided(large, p_values.size()), distance.too_far, true};
  result.uniform = std::min({result.fisher_small, result.fisher_large, result.distance}) >= alpha / 3;
  return result;
}

}  // namespace fairlight

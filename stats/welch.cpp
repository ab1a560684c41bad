#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <fairlight/stats/welch.h>

namespace fairlight {
namespace {

boost::math::students_t law_of(const EstimatedMean& a, const EstimatedMean& b) {
  const double degrees = std::min(a.degrees, b.degrees);
  if (!(degrees >= 1)) throw std::invalid_argument("a variance needs at least one degree of freedom");
  return boost::math::students_t(degrees);
}

// Hall's factor falls behind the normal tail only up to x = 1/g, and the expansion holds only well
// below that; so x counts up to half of it.
double with_hall_factor(double p, double skewness) {
  if (p >= 1 || skewness == 0) return p;
  const boost::math::normal normal;
  const double shown = std::max(p, std::numeric_limits<double>::min());
  const double x = std::min(quantile(complement(normal, shown / 2)), 0.5 / skewness);
  return std::min(1.0, 2 * cdf(complement(normal, x)) * std::exp(skewness * x * x * x / 3));
}

}  // namespace

double skewness_of_difference(const EstimatedMean& a, const EstimatedMean& b) {
  const double sum = a.squared_error + b.squared_error;
  if (sum == 0) return 0;
  const double third =
      std::abs(a.skewness) * std::pow(a.squared_error, 1.5) + std::abs(b.skewness) * std::pow(b.squared_error, 1.5);
  return third / std::pow(sum, 1.5);
}

double welch_quantile(double level, const EstimatedMean& a, const EstimatedMean& b) {
  if (!(level > 0 && level < 1)) throw std::invalid_argument("a level must be in (0, 1)");
  const double t = quantile(complement(law_of(a, b), level / 2));
  return t + skewness_of_difference(a, b) * (2 * t * t + 1) / 6;
}

double welch_p_value(const EstimatedMean& a, const EstimatedMean& b, double rounding) {
  const double beyond = std::abs(a.mean - b.mean) - rounding;
  if (!(beyond > 0)) return 1;
  const double error = std::sqrt(a.squared_error + b.squared_error);
  if (error == 0) return 0;
  const double p = 2 * cdf(complement(law_of(a, b), beyond / error));
  return with_hall_factor(p, skewness_of_difference(a, b));
}

double welch_log_p_value(const EstimatedMean& a, const EstimatedMean& b, double rounding) {
  if (!(a.mean > 0 && b.mean > 0)) return welch_p_value(a, b, rounding);
  const auto logarithm = [](const EstimatedMean& x) {
    const double deviation = std::sqrt(x.squared_error) / x.mean;
    return EstimatedMean{std::log(x.mean), deviation * deviation, x.degrees,
                         std::max(0.0, std::abs(x.skewness) - 3 * deviation)};
  };
  return welch_p_value(logarithm(a), logarithm(b), rounding / std::min(a.mean, b.mean));
}

}  // namespace fairlight

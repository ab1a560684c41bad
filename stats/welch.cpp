#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <fairlight/stats/gauss_legendre.h>
#include <fairlight/stats/welch.h>

namespace fairlight {
namespace {

constexpr double most_degrees = 200;

double student_tail(double degrees, double t) { return 2 * cdf(complement(boost::math::students_t(degrees), t)); }

double student_quantile(double degrees, double level) {
  return quantile(complement(boost::math::students_t(degrees), level / 2));
}

double counted(double degrees) { return std::min(degrees, most_degrees); }

// Welch and Satterthwaite's degrees of freedom, where a has the part `share` of the estimated
// variance.
double welch_degrees(double share, double degrees_a, double degrees_b) {
  return 1 / (share * share / degrees_a + (1 - share) * (1 - share) / degrees_b);
}

double degrees_of(const EstimatedMean& a, const EstimatedMean& b) {
  const double sum = a.squared_error + b.squared_error;
  return welch_degrees(sum > 0 ? a.squared_error / sum : 0.5, counted(a.degrees), counted(b.degrees));
}

// Hall's factor grows until x = 1/g, where the expansion no longer holds; so x counts up to half
// of that.
double with_skewness(double p, double skewness) {
  if (p >= 1 || skewness == 0) return p;
  const boost::math::normal normal;
  const double least = std::numeric_limits<double>::min();
  const double x = std::min(quantile(complement(normal, std::max(p, least) / 2)), 0.5 / skewness);
  return std::min(1.0, 2 * cdf(complement(normal, x)) * std::exp(skewness * x * x * x / 3));
}

// The integral of f over the angles at which sin^(degrees_a - 1) cos^(degrees_b - 1) is not
// negligible: ten standard deviations about its mode, in [0, pi / 2].
template <class F>
double over_angles(double degrees_a, double degrees_b, const F& f) {
  constexpr int panels = 3;
  const auto& rule = gauss_legendre<24>();
  const double mode = std::atan(std::sqrt(degrees_a / degrees_b)),
               reach = 10 / std::sqrt(2 * (degrees_a + degrees_b));
  const double low = std::max(0.0, mode - reach), high = std::min(std::numbers::pi / 2, mode + reach);
  const double width = (high - low) / panels;
  double sum = 0;
  for (int panel = 0; panel < panels; ++panel) {
    const double middle = low + width * (panel + 0.5);
    for (std::size_t i = 0; i < rule.reach.size(); ++i)
      sum += rule.weight[i] * (f(middle - width * rule.reach[i]) + f(middle + width * rule.reach[i]));
  }
  return sum * width;
}

double worst_level(double nominal, double degrees_a, double degrees_b) {
  constexpr int steps = 10;  // the level is a smooth function of the share, and flat where it is largest
  double worst = nominal;
  for (int i = 1; i < steps; ++i)
    worst = std::max(worst, true_level_of_welch(nominal, degrees_a, degrees_b, static_cast<double>(i) / steps));
  return worst;
}

}  // namespace

// With U and V chi-square and W = U + V, the part B = U / W of a is independent of W, and given B
// the statistic is Student's with degrees_a + degrees_b degrees of freedom, times a factor. B =
// sin^2(angle), where the angle has the density sin^(degrees_a - 1) cos^(degrees_b - 1), up to a
// constant.
double true_level_of_welch(double nominal, double degrees_a, double degrees_b, double share) {
  const double all = degrees_a + degrees_b;
  const auto density = [&](double angle) {
    return std::exp((degrees_a - 1) * std::log(std::sin(angle)) + (degrees_b - 1) * std::log(std::cos(angle)));
  };
  const auto tail = [&](double angle) {
    const double of_a = share * std::pow(std::sin(angle), 2) / degrees_a;
    const double of_b = (1 - share) * std::pow(std::cos(angle), 2) / degrees_b;
    const double degrees = welch_degrees(of_a / (of_a + of_b), degrees_a, degrees_b);
    const double scaled = student_quantile(degrees, nominal) * std::sqrt(all * (of_a + of_b));
    return density(angle) * student_tail(all, scaled);
  };
  return over_angles(degrees_a, degrees_b, tail) / over_angles(degrees_a, degrees_b, density);
}

double skewness_of_difference(const EstimatedMean& a, const EstimatedMean& b) {
  const double sum = a.squared_error + b.squared_error;
  if (sum == 0) return 0;
  return (std::abs(a.skewness) * std::pow(a.squared_error, 1.5) +
          std::abs(b.skewness) * std::pow(b.squared_error, 1.5)) /
         std::pow(sum, 1.5);
}

WelchTest::WelchTest(double level, double degrees_a, double degrees_b) : level_(level), nominal_(level) {
  if (!(level > 0 && level < 0.5)) throw std::invalid_argument("a level must be in (0, 0.5)");
  if (!(degrees_a >= 1 && degrees_b >= 1))
    throw std::invalid_argument("Welch's test needs a degree of freedom of each variance");
  // The ratio of true and nominal level hardly depends on the level, so this converges at once.
  for (int i = 0; i < 3; ++i) nominal_ *= level / worst_level(nominal_, counted(degrees_a), counted(degrees_b));
}

double WelchTest::quantile(const EstimatedMean& a, const EstimatedMean& b) const {
  return student_quantile(degrees_of(a, b), nominal_);
}

double WelchTest::p_value(const EstimatedMean& a, const EstimatedMean& b, double rounding) const {
  const double beyond = std::abs(a.mean - b.mean) - rounding;
  if (!(beyond > 0)) return 1;
  const double error = std::sqrt(a.squared_error + b.squared_error);
  if (error == 0) return 0;
  const double p = std::min(1.0, student_tail(degrees_of(a, b), beyond / error) * level_ / nominal_);
  return with_skewness(p, skewness_of_difference(a, b));
}

}  // namespace fairlight

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <boost/math/distributions/students_t.hpp>

#include <fairlight/stats/moments.h>
#include <fairlight/stats/ratio.h>

namespace fairlight {
namespace {

// The two-sided quantile of Student's t for n replicates.
double quantile(std::size_t n, double confidence) {
  if (n < 2) throw std::invalid_argument("an interval needs two replicates or more (one shows no spread)");
  if (!(confidence > 0 && confidence < 1))
    throw std::invalid_argument("a confidence must be between 0 and 1 (0.95 is usual)");
  const boost::math::students_t law(static_cast<double>(n - 1));
  return boost::math::quantile(boost::math::complement(law, (1 - confidence) / 2));
}

}  // namespace

Measured measured_mean(std::span<const double> replicates, double confidence) {
  const double t = quantile(replicates.size(), confidence);
  const Moments moments = Moments::of(replicates);
  const double reach = t * moments.standard_error();
  return {moments.mean(), {moments.mean() - reach, moments.mean() + reach}};
}

// Fieller's interval holds every x for which the mean of A - x B does not differ from 0. With r the
// ratio of the means and e = a - r b, whose mean is 0, these are the y = x - r with
// y^2 (mean_b^2 - k s_bb) + 2 k y s_eb - k s_ee <= 0, k = t^2 / n. In e nothing cancels, so the
// discriminant is a sum of squares.
Measured measured_ratio(std::span<const double> a, std::span<const double> b, double confidence) {
  if (a.size() != b.size())
    throw std::invalid_argument("a ratio needs pairs (there are more of one than of the other)");
  const double t = quantile(a.size(), confidence), n = static_cast<double>(a.size());
  const double mean_b = Moments::of(b).mean(), ratio = Moments::of(a).mean() / mean_b;
  double ee = 0, eb = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double e = a[i] - ratio * b[i], off = b[i] - mean_b;
    ee += e * e / (n - 1);
    eb += e * off / (n - 1);
    bb += off * off / (n - 1);
  }
  const double k = t * t / n, square = mean_b * mean_b - k * bb;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (!(square > 0)) return {ratio, {-infinite, infinite}};
  const double root = std::sqrt(k * eb * k * eb + square * k * ee);
  return {ratio, {ratio + (-k * eb - root) / square, ratio + (-k * eb + root) / square}};
}

}  // namespace fairlight

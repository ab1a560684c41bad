#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <fairlight/stats/second_order.h>

namespace fairlight {
namespace {

constexpr std::uint64_t pilot_pairs = 4096;

double range_variance(const BoundedEstimator& e) { return (e.upper - e.lower) * (e.upper - e.lower) / 2; }

// Half the squared difference of draws 2i and 2i + 1.
double pair_variance(const BoundedEstimator& e, std::uint64_t i) {
  const auto draw = [&](std::uint64_t index) {
    const double x = e.draw(index);
    if (!(x >= e.lower && x <= e.upper)) throw BadDraw(index, x, "outside its declared range");
    return x;
  };
  const double difference = draw(2 * i) - draw(2 * i + 1);
  return difference * difference / 2;
}

}  // namespace

Finding test_variance(const Trial& trial, double variance, const BoundedEstimator& estimator, Sides sides) {
  const Reference reference{variance, 0, range_variance(estimator), 0, variance, sides};
  return test_means(trial, {reference}, one_channel([&](std::uint64_t i) { return pair_variance(estimator, i); }));
}

Finding test_variance_ratio(const Trial& trial, double ratio, const BoundedEstimator& a,
                            const BoundedEstimator& b) {
  if (!(ratio > 0)) throw std::invalid_argument("a ratio of variances must be positive");
  double scale = 0;
  try {
    for (std::uint64_t i = 0; i < pilot_pairs; ++i) scale += ratio * pair_variance(b, i) / pilot_pairs;
  } catch (const BadDraw& bad) {
    Finding finding{Verdict::biased, Guarantee::deterministic, trial.margin};
    finding.note = std::string("of the second estimator, ") + bad.what();
    return with_token(trial, finding);
  }
  if (!(scale > 0))
    throw std::invalid_argument("the second estimator shows no variance (a ratio to it has no meaning)");
  // A constant A has a range of length 0.
  const double upper = std::max(range_variance(a), 2 * trial.margin * scale);
  const Reference reference{0, -ratio * range_variance(b), upper, 0, scale, Sides::not_above};
  return test_means(trial, {reference}, one_channel([&](std::uint64_t i) {
                      return pair_variance(a, pilot_pairs + i) - ratio * pair_variance(b, pilot_pairs + i);
                    }));
}

Finding test_uncorrelated(const Trial& trial, std::pair<double, double> means, double reach, double scale,
                          const std::function<std::pair<double, double>(std::uint64_t)>& draw) {
  const Reference reference{0, -reach * reach, reach * reach, 0, scale};
  return test_means(trial, {reference}, one_channel([&](std::uint64_t i) {
                      const auto [a, b] = draw(i);
                      return (a - means.first) * (b - means.second);
                    }));
}

}  // namespace fairlight

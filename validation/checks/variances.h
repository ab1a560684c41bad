#pragma once

#include <cmath>
#include <functional>
#include <string>

#include <fairlight/stats/second_order.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/checks/claim.h>
#include <fairlight/validation/checks/draws.h>

namespace fairlight {

/// Claims about variances: that of one estimator against that of another, at the same cost.

/// One of the two estimators: its name, draw `index` under a key, and the range of its draws.
struct VarianceArm {
  std::string name;
  std::function<double(const StreamKey& key, std::uint64_t index)> draw;
  double lower, upper;
};

/// The mean of an estimator in double over the points of one replicate.
template <PointSet Set, class Draw>
double replicate_mean(const StreamKey& key, std::uint64_t replicate, std::uint32_t n, const Draw& draw) {
  const Set set(key, number_in_key(replicate, "replicates"), n);
  double sum = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    auto source = set.source(i);
    sum += draw(source);
  }
  return sum / n;
}

/// An estimator from independent numbers: `draw(source)`. With n > 1, the mean of n draws from one
/// source.
template <class Draw>
VarianceArm independent_draws(const std::string& name, const Draw& draw, double lower, double upper, int n = 1) {
  return {name,
          [=](const StreamKey& key, std::uint64_t index) {
            IndependentSamples<double> numbers(key, index);
            NumberSource<double> source(numbers);
            double sum = 0;
            for (int i = 0; i < n; ++i) sum += draw(source);
            return sum / n;
          },
          lower, upper};
}

/// An estimator over the n points of a set: a draw is the mean of a replicate.
template <PointSet Set, class Draw>
VarianceArm replicates_of(const std::string& name, const Draw& draw, double lower, double upper, std::uint32_t n) {
  return {name, [=](const StreamKey& key, std::uint64_t index) { return replicate_mean<Set>(key, index, n, draw); },
          lower, upper};
}

/// Tests Var a <= ratio Var b, by the test of means on squared differences of draws. The note gives
/// the variance ratio and its interval, which has no lower end where the claim holds.
inline Finding check_variances(const Trial& trial, double ratio, const VarianceArm& a, const VarianceArm& b) {
  const auto indexed = [&](const VarianceArm& arm, const std::string& purpose) {
    const StreamKey key(trial.seed, trial.claim + purpose);
    return BoundedEstimator{[key, draw = arm.draw](std::uint64_t i) { return draw(key, i); }, arm.lower, arm.upper};
  };
  Finding finding = test_variance_ratio(trial, ratio, indexed(a, " a"), indexed(b, " b"));
  if (!finding.note.empty()) return finding;
  const double least = ratio * (1 + finding.interval.lo), most = ratio * (1 + finding.interval.hi);
  finding.note = formatted("variance ratio %.4g, ", ratio * (1 + finding.bias)) +
                 (std::isinf(least) ? formatted("at most %.4g", most) : formatted("in [%.4g, %.4g]", least, most));
  return finding;
}

/// The row of the registry for check_variances.
inline Claim variance_claim(const std::string& name, std::vector<std::string> subjects, const std::string& source,
                            double ratio, double margin_factor, const VarianceArm& a, const VarianceArm& b) {
  return {.name = name,
          .kind = "variance",
          .subjects = std::move(subjects),
          .statement = a.name + " has at most " + formatted("%.6g", ratio) + " times the variance of " + b.name,
          .source = source,
          .margin_factor = margin_factor,
          .check = [=](const Trial& trial) { return check_variances(trial, ratio, a, b); }};
}

}  // namespace fairlight

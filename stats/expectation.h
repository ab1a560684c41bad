#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <fairlight/stats/catoni_test.h>
#include <fairlight/stats/estimator_draws.h>
#include <fairlight/stats/follows.h>
#include <fairlight/stats/limits.h>
#include <fairlight/stats/margin.h>
#include <fairlight/stats/mean_test.h>
#include <fairlight/stats/same_law.h>
#include <fairlight/stats/site.h>

namespace fairlight {

/// A finding in the form that a test framework needs.
struct Expectation {
  bool met;
  /// The verdict, the numbers, a histogram and how to replay; for the reader of a failure.
  std::string message;
};

/// A mean whose draws all lie in [lower, upper]: tested exactly, by betting. One end may be
/// infinite; what needs it is then asymptotic. Throws std::invalid_argument for an empty range.
Reference bounded(double mean, double lower, double upper);
/// A mean of draws that are never negative: that it is not too high is tested exactly.
inline Reference nonnegative(double mean) { return bounded(mean, 0, std::numeric_limits<double>::infinity()); }

/// A mean of draws without a range whose variance is at most `variance`: exact, given that.
inline FiniteVariance finite_variance(double mean, double variance) { return {mean, variance}; }

/// The same as bounded for an array or an Eigen vector of means, one for each channel.
template <class Means>
requires requires(const Means& means) { means[0], means.size(); }
std::vector<Reference> bounded(const Means& means, double lower, double upper) {
  std::vector<Reference> references;
  for (double mean : means) references.push_back(bounded(mean, lower, upper));
  return references;
}

/// Expects that the mean of `estimator(generator)` is the reference, within the margin. With plain
/// numbers the draws have no declared range: the test is asymptotic, and says nothing of a mean
/// that is off. With bounded(...) it is exact. For arrays or Eigen vectors of draws give as many
/// references; each channel has an equal part of the budget.
template <class Estimator, class References>
Expectation expect_unbiased(const Site& site, Estimator&& estimator, const References& references, Margin margin,
                            Limits limits = {});
/// The same for a mean of at most, or at least, the reference.
template <class Estimator, class References>
Expectation expect_at_most(const Site& site, Estimator&& estimator, const References& references, Margin margin,
                           Limits limits = {});
template <class Estimator, class References>
Expectation expect_at_least(const Site& site, Estimator&& estimator, const References& references, Margin margin,
                            Limits limits = {});

/// Expects that the variance of an estimator is at most `variance`, from pairs of draws. Exact for
/// in_range(estimator, lower, upper); otherwise only what is too large is found exactly.
template <class Estimator>
Expectation expect_variance_at_most(const Site& site, Estimator&& estimator, double variance, Margin margin,
                                    Limits limits = {});

/// Expects that intervals cover the reference as often as they say, by betting on their misses:
/// exact. `estimator(generator)` returns an Interval{lo, hi} of the level, or an Estimate{value,
/// standard_error}. The margin is relative to the miss rate 1 - level.
template <class Estimator>
Expectation expect_intervals(const Site& site, Estimator&& estimator, double reference, double level = 0.95,
                             Margin margin = 0.1, Limits limits = {});

/// Expects that the points `sampler(generator)` follow `density(point)` over the domain (see
/// stats/domains.h and domain_options.h), or a table of probabilities. The margin is a relative L2
/// distance between laws, in cells, and of each bounded moment (test_follows).
template <class Sampler, class Pdf, class Domain>
Expectation expect_follows(const Site& site, Sampler&& sampler, Pdf&& density, const Domain& domain,
                           double margin = 0.01, Limits limits = {});

/// Expects that the points of two samplers follow the same law on a domain that holds both. Needs no
/// density. See test_same_law for what is exact, and what is certified.
template <class A, class B, class Domain>
Expectation expect_same_law(const Site& site, A&& a, B&& b, const Domain& domain, double margin = 0.01,
                            Limits limits = {});

/// Expects that two estimators have the same mean: exactly, by betting on differences, for
/// in_range(a, lower, upper) and in_range(b, lower, upper); otherwise by Welch's test, which says
/// nothing of means that differ. A plain margin is relative to the mean of `b`, of which a pilot
/// gives a lower bound; a mean near 0 is refused, with what to give.
template <class A, class B>
Expectation expect_agree(const Site& site, A&& a, B&& b, Margin margin, Limits limits = {});

namespace detail {

/// What a message says beyond the finding: the unit of the bias, and a warning or nothing.
struct Wording {
  double unit = 1;
  std::string unit_name = "all relative";
  std::string warning{};
};

/// The expectation for a finding; the message shows `sample` as a histogram. One that is met prints
/// its message if FAIRLIGHT_VERBOSE is set, and its warning in any case.
Expectation judge(const Site& site, const Trial& trial, const std::string& claim, const Finding& finding,
                  const std::vector<double>& sample, const Wording& wording = {});

/// Expects these means of the channels of an estimator. The claims are "`of` is 0.5" and so on.
Expectation expect_means(const Site& site, const std::string& of, std::vector<Reference> references,
                         const Margin& margin, const Limits& limits, const EstimatorDraws& draws);

/// The claim of a variance about half the squared difference of two draws.
Reference variance_reference(double variance, const Interval& range);

/// Expects a mean of draws of finite variance.
Expectation expect_mean(const Site& site, const FiniteVariance& claim, const Margin& margin, const Limits& limits,
                        const EstimatorDraws& draws);

/// Expects that two estimators of `channels` channels agree in their means.
Expectation expect_agreement(const Site& site, std::size_t channels, const std::array<Interval, 2>& ranges,
                             const Margin& margin, const Limits& limits,
                             const std::array<EstimatorDraws, 2>& draws);

/// 1 - level. Throws std::invalid_argument for a level outside (0,1).
double miss_rate_of(double level);

/// The references with these sides.
std::vector<Reference> on_sides(std::vector<Reference> references, Sides sides);

/// Up to 4096 draws, and no more than take two seconds, for a histogram.
template <class Draw>
std::vector<double> sample_of(Draw&& draw) {
  Meter meter({4096, 2});
  std::vector<double> sample;
  try {
    for (;;) {
      meter.draw();
      sample.push_back(draw());
    }
  } catch (const NoMoreDraws&) {
    return sample;
  } catch (const BadDraw&) {  // which the finding names
    return sample;
  }
}

}  // namespace detail

template <class Estimator, class References>
Expectation expect_unbiased(const Site& site, Estimator&& estimator, const References& references, Margin margin,
                            Limits limits) {
  if constexpr (std::is_same_v<References, FiniteVariance>) {
    return detail::expect_mean(site, references, margin, limits, detail::draws_of(estimator));
  } else {
    return detail::expect_means(site, "the mean", detail::references_of(references), margin, limits,
                                detail::draws_of(estimator));
  }
}

template <class Estimator, class References>
Expectation expect_at_most(const Site& site, Estimator&& estimator, const References& references, Margin margin,
                           Limits limits) {
  return detail::expect_means(site, "the mean",
                              detail::on_sides(detail::references_of(references), Sides::not_above), margin, limits,
                              detail::draws_of(estimator));
}

template <class Estimator, class References>
Expectation expect_at_least(const Site& site, Estimator&& estimator, const References& references, Margin margin,
                            Limits limits) {
  return detail::expect_means(site, "the mean",
                              detail::on_sides(detail::references_of(references), Sides::not_below), margin, limits,
                              detail::draws_of(estimator));
}

template <class Estimator>
Expectation expect_variance_at_most(const Site& site, Estimator&& estimator, double variance, Margin margin,
                                    Limits limits) {
  const Interval range = detail::range_of(estimator);
  const auto references = detail::on_sides({detail::variance_reference(variance, range)}, Sides::not_above);
  return detail::expect_means(site, "the variance", references, margin, limits,
                              detail::pair_variances(detail::draws_of(estimator), range));
}

template <class Estimator>
Expectation expect_intervals(const Site& site, Estimator&& estimator, double reference, double level, Margin margin,
                             Limits limits) {
  auto miss = [&](Generator& generator) { return detail::misses(estimator(generator), level, reference); };
  return detail::expect_means(site, "the rate at which intervals miss " + std::to_string(reference),
                              {bounded(detail::miss_rate_of(level), 0, 1)}, margin, limits, detail::draws_of(miss));
}

template <class Sampler, class Pdf, class Domain>
Expectation expect_follows(const Site& site, Sampler&& sampler, Pdf&& density, const Domain& domain, double margin,
                           Limits limits) {
  const Trial trial = trial_at(site, margin);
  Generator generator = generator_for(trial);
  Meter meter(limits);
  const Finding finding = test_follows(trial, domain, density, [&](std::uint64_t) {
    meter.draw();
    return sampler(generator);
  });
  const Eigen::Vector2d none = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  const auto coordinate = [&] { return detail::place_or_lost(domain, sampler(generator)).value_or(none).x(); };
  const bool certified = finding.verdict == Verdict::certified;
  return detail::judge(site, trial, "the draws follow the density", finding,
                       certified ? std::vector<double>() : detail::sample_of(coordinate));
}

template <class A, class B, class Domain>
Expectation expect_same_law(const Site& site, A&& a, B&& b, const Domain& domain, double margin, Limits limits) {
  const Trial trial = trial_at(site, margin);
  Generator of_a = generator_for(trial, "a");
  Generator of_b = generator_for(trial, "b");
  Meter meter(limits);
  const auto place_of_a = [&](std::uint64_t) {
    meter.draw();
    return detail::place_or_lost(domain, a(of_a));
  };
  const auto place_of_b = [&](std::uint64_t) {
    meter.draw();
    return detail::place_or_lost(domain, b(of_b));
  };
  const Finding finding = test_same_law(trial, place_of_a, place_of_b, detail::landmarks_of(domain).line);
  const Eigen::Vector2d none = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  const auto coordinate = [&] { return detail::place_or_lost(domain, a(of_a)).value_or(none).x(); };
  const bool certified = finding.verdict == Verdict::certified;
  return detail::judge(site, trial, "the two laws are the same", finding,
                       certified ? std::vector<double>() : detail::sample_of(coordinate));
}

template <class A, class B>
Expectation expect_agree(const Site& site, A&& a, B&& b, Margin margin, Limits limits) {
  return detail::expect_agreement(site, detail::channels_of(site, b), {detail::range_of(a), detail::range_of(b)},
                                  margin, limits, {detail::draws_of(a), detail::draws_of(b)});
}

}  // namespace fairlight

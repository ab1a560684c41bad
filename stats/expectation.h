#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <fairlight/stats/follows.h>
#include <fairlight/stats/mean_test.h>
#include <fairlight/stats/same_law.h>
#include <fairlight/stats/sequential_t_test.h>

namespace fairlight {

/// The generator that is passed to estimators under test. Its seed comes from the run's seed and
/// the claim's name.
using Generator = std::mt19937_64;

/// A finding in the form that a test framework needs.
struct Expectation {
  bool met;
  /// The verdict, the numbers, a histogram and how to replay; for the reader of a failure.
  std::string message;
};

/// The place of an expectation in a test program. It determines the expectation's share of the
/// false alarms and its random numbers.
struct Site {
  std::string name;       ///< name of the test, unique in the program
  std::uint64_t tests;    ///< number of tests in the whole program, whatever subset runs
  std::uint64_t ordinal;  ///< number of the expectation in its test: 1, 2, ...
  std::string replay;     ///< how to run the test again, without the seed
};

/// The trial at a site. The program's tests share the false-alarm budget of 1e-6 equally. Within a
/// test the k-th expectation has the part 6 / (pi k)^2, which sums to 1 over all k. So no list of
/// expectations is needed, and running a subset changes no share. The seed is FAIRLIGHT_SEED
/// (hexadecimal) if that is set, otherwise fresh. Throws std::invalid_argument for a margin outside
/// (0,1) or a seed that cannot be parsed.
Trial trial_at(const Site& site, double margin);

/// A generator for a trial's claim. Different values of `purpose` give independent generators.
Generator generator_for(const Trial& trial, const std::string& purpose = "");

/// A mean whose draws all lie in [lower, upper]: tested exactly, by betting.
inline Reference bounded(double mean, double lower, double upper) {
  return {mean, lower, upper, 0, std::abs(mean)};
}

/// Expects that the mean of `estimator(generator)` is the reference, within the relative margin.
/// With a plain number the draws have no declared range and the test is asymptotic; with
/// `bounded(...)` it is exact.
template <class Estimator>
Expectation expect_unbiased(const Site& site, Estimator&& estimator, const Reference& reference, double margin);
template <class Estimator>
Expectation expect_unbiased(const Site& site, Estimator&& estimator, double reference, double margin);

/// Expects that the points `sampler(generator)` follow `density(point)` over the domain (see
/// stats/domains.h and domain_options.h), or a table of probabilities. The margin is a relative L2
/// distance between laws, in cells, and of each bounded moment (test_follows).
template <class Sampler, class Pdf, class Domain>
Expectation expect_follows(const Site& site, Sampler&& sampler, Pdf&& density, const Domain& domain,
                           double margin = 0.01);

/// Expects that the points of two samplers follow the same law on a domain that holds both. Needs no
/// density. See test_same_law for what is exact, and what is certified.
template <class A, class B, class Domain>
Expectation expect_same_law(const Site& site, A&& a, B&& b, const Domain& domain, double margin = 0.01);

/// Expects that two estimators have the same mean, by Welch's test. The margin is relative to the
/// mean of `b` in a discarded pilot, which has no other use.
template <class A, class B>
Expectation expect_agree(const Site& site, A&& a, B&& b, double margin);

namespace detail {

/// The expectation for a finding; the message shows `sample` as a histogram.
Expectation judge(const Site& site, const Trial& trial, const std::string& claim, const Finding& finding,
                  const std::vector<double>& sample);

/// The absolute mean of a pilot; 1 where it is 0 or not finite, as the draws themselves then show
/// the fault.
double scale_of(const std::vector<double>& pilot);

/// Fills the first channel with draw(), in order.
template <class Draw>
DrawBlock one_by_one(Draw& draw) {
  return [&draw](std::uint64_t, std::vector<std::vector<double>>& channels) {
    for (double& x : channels[0]) x = draw();
  };
}

template <class Draw>
std::vector<double> sample_of(Draw&& draw) {
  std::vector<double> sample(4096);
  for (double& x : sample) x = draw();
  return sample;
}

}  // namespace detail

template <class Estimator>
Expectation expect_unbiased(const Site& site, Estimator&& estimator, const Reference& reference, double margin) {
  const Trial trial = trial_at(site, margin);
  Generator generator = generator_for(trial);
  auto draw = [&] { return static_cast<double>(estimator(generator)); };
  const Finding finding = test_means(trial, {reference}, detail::one_by_one(draw));
  return detail::judge(site, trial, "the mean is " + std::to_string(reference.mean), finding,
                       detail::sample_of(draw));
}

template <class Estimator>
Expectation expect_unbiased(const Site& site, Estimator&& estimator, double reference, double margin) {
  const Trial trial = trial_at(site, margin);
  Generator generator = generator_for(trial);
  auto draw = [&] { return static_cast<double>(estimator(generator)); };
  const Finding finding = sequential_t_test(trial, reference, std::abs(reference), detail::one_by_one(draw));
  return detail::judge(site, trial, "the mean is " + std::to_string(reference), finding, detail::sample_of(draw));
}

template <class Sampler, class Pdf, class Domain>
Expectation expect_follows(const Site& site, Sampler&& sampler, Pdf&& density, const Domain& domain,
                           double margin) {
  const Trial trial = trial_at(site, margin);
  Generator generator = generator_for(trial);
  const Eigen::Vector2d none = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  const Finding finding = test_follows(trial, domain, density, [&](std::uint64_t) { return sampler(generator); });
  const auto coordinate = [&] { return detail::place_or_lost(domain, sampler(generator)).value_or(none).x(); };
  return detail::judge(site, trial, "the draws follow the density", finding, detail::sample_of(coordinate));
}

template <class A, class B, class Domain>
Expectation expect_same_law(const Site& site, A&& a, B&& b, const Domain& domain, double margin) {
  const Trial trial = trial_at(site, margin);
  Generator of_a = generator_for(trial, "a");
  Generator of_b = generator_for(trial, "b");
  const auto place_of_a = [&](std::uint64_t) { return detail::place_or_lost(domain, a(of_a)); };
  const auto place_of_b = [&](std::uint64_t) { return detail::place_or_lost(domain, b(of_b)); };
  const Finding finding = test_same_law(trial, place_of_a, place_of_b, detail::landmarks_of(domain).line);
  const Eigen::Vector2d none = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  const auto coordinate = [&] { return place_of_a(0).value_or(none).x(); };
  return detail::judge(site, trial, "the two laws are the same", finding, detail::sample_of(coordinate));
}

template <class A, class B>
Expectation expect_agree(const Site& site, A&& a, B&& b, double margin) {
  const Trial trial = trial_at(site, margin);
  Generator of_a = generator_for(trial, "a");
  Generator of_b = generator_for(trial, "b");
  Generator of_pilot = generator_for(trial, "pilot");
  const auto pilot = detail::sample_of([&] { return static_cast<double>(b(of_pilot)); });
  const double scale = detail::scale_of(pilot);
  const Finding finding =
      sequential_welch_test(trial, scale, [&](std::uint64_t, std::vector<std::vector<double>>& channels) {
        for (double& x : channels[0]) x = static_cast<double>(a(of_a));
        for (double& x : channels[1]) x = static_cast<double>(b(of_b));
      });
  const auto difference = [&] { return static_cast<double>(a(of_a)) - static_cast<double>(b(of_b)); };
  return detail::judge(site, trial, "the two means agree", finding, detail::sample_of(difference));
}

}  // namespace fairlight

#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <fairlight/stats/law_test.h>
#include <fairlight/stats/mean_test.h>
#include <fairlight/stats/sequential_t_test.h>

namespace fairlight {

/// The generator that estimators under test are given. Seeded from the run's token and the claim's name.
using Generator = std::mt19937_64;

/// What a test framework makes of a finding.
struct Expectation {
  bool met;
  std::string message;  ///< verdict, numbers, a table, and how to replay; worth reading when it is not met
};

/// Where an expectation stands, which gives it its share of the false alarms and its random numbers.
struct Site {
  std::string name;       ///< of the test, unique in the program
  std::uint64_t tests;    ///< in the whole program, whatever subset runs
  std::uint64_t ordinal;  ///< of the expectation in its test: 1, 2, ...
  std::string replay;     ///< how to run the test again, without the seed
};

/// The trial at a site. The budget of 1e-6 is shared evenly among the program's tests, and within a test the k-th
/// expectation has 6 / (pi k)^2 of it, which adds up to one however many there are: no list of expectations is
/// needed, and running a subset changes no share. The seed is FAIRLIGHT_SEED (hexadecimal) where that is set, else
/// fresh. Throws std::invalid_argument for a margin outside (0,1) or a seed that cannot be read.
Trial trial_at(const Site& site, double margin);

/// A generator for a trial's claim; `purpose` sets apart several of one claim.
Generator generator_for(const Trial& trial, const std::string& purpose = "");

/// A mean with a range that holds for every draw: tested exactly, by betting.
inline Reference bounded(double mean, double lower, double upper) {
  return {mean, lower, upper, 0, std::abs(mean)};
}

/// The mean of `estimator(generator)` is the reference to within the relative margin. With a number for a reference
/// the draws have no declared range, and the test is asymptotic; with `bounded(...)` it is exact.
template <class Estimator>
Expectation expect_unbiased(const Site& site, Estimator&& estimator, const Reference& reference, double margin);
template <class Estimator>
Expectation expect_unbiased(const Site& site, Estimator&& estimator, double reference, double margin);

/// `sampler(generator)` gives points that follow `density(point)` over the domain (see stats/domains.h); the margin
/// is a relative L2 distance of laws.
template <class Sampler, class Pdf, class Domain>
Expectation expect_follows(const Site& site, Sampler&& sampler, Pdf&& density, const Domain& domain,
                           double margin = 0.01);

/// Two estimators have one mean, to within the margin relative to `b`'s mean in a discarded pilot, which sets the
/// scale and nothing else. By Welch's test.
template <class A, class B>
Expectation expect_agree(const Site& site, A&& a, B&& b, double margin);

namespace detail {

/// The message for a finding; `sample` is drawn as a histogram.
Expectation judge(const Site& site, const Trial& trial, const std::string& claim, const Finding& finding,
                  const std::vector<double>& sample);

/// The size of a pilot's mean; 1 where that is 0 or not finite, as then the draws themselves show what is wrong.
double scale_of(const std::vector<double>& pilot);

/// Fills channels from draw(), in order.
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
  const Finding finding = test_law(trial, domain, density, [&](std::uint64_t) { return sampler(generator); });
  const auto coordinate = [&] { return domain.coordinates(sampler(generator)).x(); };
  return detail::judge(site, trial, "the draws follow the density", finding, detail::sample_of(coordinate));
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

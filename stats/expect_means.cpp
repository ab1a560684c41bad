#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <boost/math/distributions/normal.hpp>

#include <fairlight/stats/channel_findings.h>
#include <fairlight/stats/dependence.h>
#include <fairlight/stats/expectation.h>
#include <fairlight/stats/sequential_t_test.h>
#include <fairlight/stats/text.h>

namespace fairlight {
namespace {

using detail::EstimatorDraws;
using Channels = std::vector<std::vector<double>>;

// The draws of one expectation: their generator, their number, and how they depend on each other.
class Draws {
 public:
  Draws(const EstimatorDraws& draws, Meter& meter, const Generator& generator, std::size_t channels)
      : draws_(draws), meter_(meter), generator_(generator), lags_(channels) {}

  void fill(Channels& channels) {
    draws_(generator_, meter_, channels);
    for (std::size_t c = 0; c < channels.size(); ++c) lags_[c].add(channels[c]);
  }

  std::string warning() const {
    for (const LagOne& lag : lags_) {
      if (const std::string text = lag.warning(); !text.empty()) return text;
    }
    return {};
  }

 private:
  const EstimatorDraws& draws_;
  Meter& meter_;
  Generator generator_;
  std::vector<LagOne> lags_;
};

// Channel `channel` of up to 4096 draws.
std::vector<double> sample_of_channel(Draws& draws, std::size_t channel, std::size_t channels) {
  Channels one(channels, std::vector<double>(1));
  return detail::sample_of([&] {
    draws.fill(one);
    return one[channel][0];
  });
}

bool has_range(const Reference& r) { return std::isfinite(r.lower) && std::isfinite(r.upper); }

void check_references(std::vector<Reference>& references, const Margin& margin) {
  if (references.empty()) throw std::invalid_argument("there are no references (give one for each channel)");
  for (Reference& r : references) {
    if (!std::isfinite(r.mean))
      throw std::invalid_argument(formatted("the reference is %g (give a finite number)", r.mean));
    if (r.sides == Sides::both && !(r.lower <= r.mean && r.mean <= r.upper))
      throw std::invalid_argument(formatted(
          "the reference %g lies outside its range [%g, %g] (correct one of them)", r.mean, r.lower, r.upper));
    r.scale = margin.scale(r.mean);
  }
}

// Without a range each channel is tested on draws of its own, which have all channels.
Finding test_channel(const Trial& trial, const std::vector<Reference>& references, std::size_t channel,
                     Draws& draws) {
  Trial part = trial;
  part.alpha /= static_cast<double>(references.size());
  Channels all(references.size());
  const DrawBlock block = [&](std::uint64_t, Channels& channels) {
    for (auto& each : all) each.resize(channels[0].size());
    draws.fill(all);
    channels[0] = all[channel];
  };
  const Reference& r = references[channel];
  return sequential_t_test(part, {r.mean, r.scale, r.sides, r.lower, r.upper}, block);
}

std::string claim_of(const std::string& of, const Reference& r) {
  const char* is = r.sides == Sides::both ? "is" : r.sides == Sides::not_above ? "is at most" : "is at least";
  return of + formatted(" %s %.10g", is, r.mean);
}

}  // namespace

Expectation detail::expect_means(const Site& site, const std::string& of, std::vector<Reference> references,
                                 const Margin& margin, const Limits& limits, const EstimatorDraws& estimator) {
  const Trial trial = trial_at(site, margin.share());
  check_references(references, margin);
  const std::size_t n = references.size();
  Meter meter(limits);
  Draws draws(estimator, meter, generator_for(trial), n);
  std::vector<Finding> findings;
  if (std::ranges::all_of(references, has_range)) {
    findings = test_each_mean(trial, references, [&](std::uint64_t, Channels& channels) { draws.fill(channels); });
  } else {
    for (std::size_t c = 0; c < n; ++c) findings.push_back(test_channel(trial, references, c, draws));
  }
  const std::size_t c = worst_channel(findings);
  const double scale = references[c].scale;
  const bool met = findings[c].verdict == Verdict::certified;
  const bool one_for_all = n > 1 && std::ranges::all_of(findings, [&](const Finding& f) {
                             return f.verdict == Verdict::biased && f.note == findings[0].note;
                           });
  const std::string claim = one_for_all ? formatted("%s of each of %zu channels", of.c_str(), n)
                                        : channel_name(c, n) + claim_of(of, references[c]);
  return judge(site, trial, claim, findings[c], met ? std::vector<double>() : sample_of_channel(draws, c, n),
               {margin.unit(scale), margin.unit_name(scale), draws.warning()});
}

Expectation detail::expect_mean(const Site& site, const FiniteVariance& claim, const Margin& margin,
                                const Limits& limits, const EstimatorDraws& estimator) {
  const Trial trial = trial_at(site, margin.share());
  const double scale = margin.scale(claim.mean);
  Meter meter(limits);
  Draws draws(estimator, meter, generator_for(trial), 1);
  const Finding finding =
      catoni_test(trial, claim, scale, [&](std::uint64_t, Channels& channels) { draws.fill(channels); });
  return judge(site, trial, formatted("the mean is %.10g", claim.mean), finding,
               finding.verdict == Verdict::certified ? std::vector<double>() : sample_of_channel(draws, 0, 1),
               {margin.unit(scale), margin.unit_name(scale), draws.warning()});
}

double detail::misses(const Interval& interval, double, double reference) {
  if (!(interval.lo <= interval.hi)) return std::numeric_limits<double>::quiet_NaN();
  return interval.lo <= reference && reference <= interval.hi ? 0 : 1;
}

double detail::misses(const Estimate& estimate, double level, double reference) {
  const double reach = boost::math::quantile(boost::math::normal(), (1 + level) / 2) * estimate.standard_error;
  return misses(Interval{estimate.value - reach, estimate.value + reach}, level, reference);
}

double detail::miss_rate_of(double level) {
  if (!(level > 0 && level < 1))
    throw std::invalid_argument(formatted("the level of the intervals is %g (give one in (0,1))", level));
  return 1 - level;
}

void detail::check_channels(std::size_t drawn, std::size_t expected) {
  if (drawn != expected)
    throw std::invalid_argument(
        formatted("a draw has %zu channels, and %zu are expected (give one reference for each)", drawn, expected));
}

Reference detail::variance_reference(double variance, const Interval& range) {
  if (!(variance > 0 && std::isfinite(variance)))
    throw std::invalid_argument(formatted("the variance is %g (give a positive number)", variance));
  return bounded(variance, 0, (range.hi - range.lo) * (range.hi - range.lo) / 2);
}

detail::EstimatorDraws detail::pair_variances(EstimatorDraws draws, const Interval& range) {
  return [draws = std::move(draws), range, pairs = Channels(1), drawn = std::uint64_t{0}](
             Generator& generator, Meter& meter, Channels& channels) mutable {
    pairs[0].resize(2 * channels[0].size());
    draws(generator, meter, pairs);
    for (std::size_t i = 0; i < pairs[0].size(); ++i, ++drawn) {
      if (!(std::isfinite(pairs[0][i]) && pairs[0][i] >= range.lo && pairs[0][i] <= range.hi))
        throw BadDraw(drawn, pairs[0][i], "outside its declared range");
    }
    for (std::size_t i = 0; i < channels[0].size(); ++i) {
      const double difference = pairs[0][2 * i] - pairs[0][2 * i + 1];
      channels[0][i] = difference * difference / 2;
    }
  };
}

}  // namespace fairlight

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <fairlight/estimators/concepts.h>
#include <fairlight/estimators/point_set.h>
#include <fairlight/stats/mean_test.h>
#include <fairlight/validation/claim.h>
#include <fairlight/validation/recording.h>

namespace fairlight {

/// The checks of the registry: the tests of stats, fed by streams that depend on the trial's seed and claim alone.

/// What the arithmetic of a Real may add to a mean or take from it, relative: nothing that shows in double. In
/// floats, 84 roundings of half an ulp, 2^-24, that all go one way: more than any component makes.
template <class Real>
inline constexpr double arithmetic_rounding = lanes<Real> > 1 ? 5e-6 : 0;

namespace detail {

/// One channel of a draw: the number itself, or a colour's.
template <class Value>
auto channel_of(const Value& x, std::size_t c) {
  if constexpr (requires { x.rows(); }) {
    return x[static_cast<Eigen::Index>(c)];
  } else {
    return x;
  }
}

/// A point of the lane, in double: a number or a vector.
template <class Point>
auto lane_of(const Point& x, std::size_t lane) {
  const auto number = [lane](const auto& value) {
    std::array<double, lanes<std::remove_cvref_t<decltype(value)>>> values{};
    store_lanes(value, values.data());
    return values[lane];
  };
  if constexpr (requires { x.rows(); }) {
    Eigen::Matrix<double, Point::RowsAtCompileTime, 1> point;
    for (Eigen::Index i = 0; i < point.size(); ++i) point[i] = number(x[i]);
    return point;
  } else {
    return number(x);
  }
}

}  // namespace detail

/// References as a Real can keep them: the range widened, and the mean allowed to be off, by its rounding.
template <class Real>
std::vector<Reference> rounded_references(std::vector<Reference> references) {
  for (Reference& r : references) {
    const double slack = 4 * arithmetic_rounding<Real> * std::max(std::abs(r.lower), std::abs(r.upper));
    r.lower -= r.lower == 0 ? 0 : slack;
    r.upper += slack;
    r.rounding += arithmetic_rounding<Real>;
  }
  return references;
}

/// Draws that are made lanes<Real> at a time: `make(first, places)` puts channel c of draw first + i at places[c][i]. Where the range is
/// wide a test asks for single draws: a packet then serves as many of its blocks as it has lanes.
template <class Real, class Make>
DrawBlock draws_at_once(std::size_t channel_count, const Make& make) {
  constexpr std::size_t n = lanes<Real>;
  return
      [make, places = std::vector<double*>(channel_count), held = std::vector<std::array<double, n>>(channel_count),
       made = std::numeric_limits<std::uint64_t>::max()](std::uint64_t first,
                                                         std::vector<std::vector<double>>& channels) mutable {
        const std::size_t size = channels[0].size();
        for (std::size_t i = 0, count = n; i < size; i += count) {
          const std::uint64_t number = (first + i) / n;
          const std::size_t lane = (first + i) % n;
          count = std::min(n - lane, size - i);
          const bool whole = count == n;
          for (std::size_t c = 0; c < channels.size(); ++c) places[c] = whole ? &channels[c][i] : held[c].data();
          if (whole || number != made) make(n * number, places);
          if (whole) continue;
          made = number;
          for (std::size_t c = 0; c < channels.size(); ++c) std::copy_n(&held[c][lane], count, &channels[c][i]);
        }
      };
}

/// Those of an estimator from independent numbers: `draw(source)` gives a Real or an Rgb<Real>.
template <class Real, class Draw>
DrawBlock independent_draws(const StreamKey& key, std::size_t channel_count, const Draw& draw) {
  return draws_at_once<Real>(channel_count, [key, draw](std::uint64_t first, const auto& places) {
    StreamNumbers<Real> source(key, first);
    const auto x = draw(source);
    for (std::size_t c = 0; c < places.size(); ++c) store_lanes(detail::channel_of(x, c), places[c]);
  });
}

/// The mean of an estimator, one reference per channel.
template <class Real = double, class Draw>
Finding check_mean(const Trial& trial, const std::vector<Reference>& references, const Draw& draw) {
  const StreamKey key(trial.seed, trial.claim);
  return test_means(trial, rounded_references<Real>(references),
                    independent_draws<Real>(key, references.size(), draw));
}

/// How many points a replicate has that is tested: a power of two, for Sobol's points to be a net, and few, since
/// the core test needs some 5 range / (margin mean) replicates however little they vary.
inline constexpr std::uint32_t points_a_replicate = 64;

/// As many; fewer where the range is so wide that it alone sets how many replicates there must be.
inline std::uint32_t points_for(const std::vector<Reference>& references) {
  const auto wide = [](const Reference& r) { return r.upper - r.lower > 8 * std::abs(r.scale); };
  return std::ranges::any_of(references, wide) ? points_a_replicate / 4 : points_a_replicate;
}

namespace detail {

/// The sum of a number's lanes, or of those of each of several, in double.
template <class Value>
auto sum_of_lanes(const Value& x) {
  const auto sum = [](const auto& channel) {
    std::array<double, lanes<std::remove_cvref_t<decltype(channel)>>> values{};
    store_lanes(channel, values.data());
    return std::accumulate(values.begin(), values.end(), 0.0);
  };
  if constexpr (requires { x.rows(); }) {
    Eigen::Array<double, Value::RowsAtCompileTime, 1> sums;
    for (Eigen::Index i = 0; i < sums.size(); ++i) sums[i] = sum(x[i]);
    return sums;
  } else {
    return sum(x);
  }
}

}  // namespace detail

/// The number of a draw as that of a replicate, a set or a pixel, `what`, of which a key has 2^32. Throws NoMoreDraws beyond.
inline std::uint32_t number_in_key(std::uint64_t i, const char* what) {
  if (i >> 32 != 0) throw NoMoreDraws(std::string(what) + " have run out (there are 2^32 of one key)");
  return static_cast<std::uint32_t>(i);
}

/// The mean of an estimator over the points of one replicate of a set, which must fill whole packets (else
/// std::invalid_argument).
template <PointSet Set, class Draw>
auto replicate_mean(const StreamKey& key, std::uint64_t replicate, std::uint32_t n, const Draw& draw) {
  constexpr auto at_once = static_cast<std::uint32_t>(lanes<typename Set::Scalar>);
  if (n % at_once != 0)
    throw std::invalid_argument("a replicate must fill whole packets (give a multiple of lanes)");
  const Set set(key, number_in_key(replicate, "replicates"), n);
  auto source = set.source(0);
  auto total = draw(source);
  for (std::uint32_t i = at_once; i < n; i += at_once) {
    auto next = set.source(i);
    total += draw(next);
  }
  const auto sum = detail::sum_of_lanes(total);
  return decltype(detail::sum_of_lanes(total))(sum / static_cast<double>(n));
}

/// References of the means of replicates of n points: the range is that of the estimator, but for the n roundings of the sum in double.
/// What lanes round before, rounded_references leaves room for.
inline std::vector<Reference> replicate_references(std::vector<Reference> references, std::uint32_t n) {
  for (Reference& r : references) {
    const double slack = n * ulp<double> * std::max(std::abs(r.lower), std::abs(r.upper));
    r.lower -= r.lower == 0 ? 0 : slack;
    r.upper += slack;
  }
  return references;
}

namespace detail {

/// Throws BadDraw where one of several that a draw is the mean of is ruled out by its reference, which the mean may hide. In a packet it is
/// the same draw in all lanes, or the next in each.
template <class Value>
void require_in_range(std::uint64_t draw, const Value& x, const std::vector<Reference>& references,
                      std::uint64_t next = 0) {
  for (std::size_t c = 0; c < references.size(); ++c) {
    const auto channel = channel_of(x, c);
    using Real = std::remove_cvref_t<decltype(channel)>;
    const double lower = references[c].lower;
    const double upper = references[c].tail_slack > 0 ? infinity<double> : references[c].upper;
    if (!any(!(channel >= rounded<Real>(lower) && channel <= rounded<Real>(upper)))) continue;
    std::array<double, lanes<Real>> values{};
    store_lanes(channel, values.data());
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!(values[i] >= lower && values[i] <= upper))
        throw BadDraw(draw + i * next, values[i], "one of those that it is the mean of, out of its declared range");
    }
  }
}

}  // namespace detail

/// Whole replicates as draws, of points that have these references.
template <PointSet Set, class Draw>
DrawBlock replicate_draws(const StreamKey& key, const std::vector<Reference>& references, const Draw& draw,
                          std::uint32_t n) {
  return [key, references, draw, n](std::uint64_t first, std::vector<std::vector<double>>& channels) {
    for (std::size_t i = 0; i < channels[0].size(); ++i) {
      const auto mean = replicate_mean<Set>(key, first + i, n, [&](auto& source) {
        const auto x = draw(source);
        detail::require_in_range(first + i, x, references);
        return x;
      });
      for (std::size_t c = 0; c < channels.size(); ++c) channels[c][i] = detail::channel_of(mean, c);
    }
  };
}

/// The mean of an estimator from a point set, in its arithmetic: whole replicates are the draws of the core test.
template <PointSet Set, class Draw>
Finding check_replicates(const Trial& trial, const std::vector<Reference>& references, const Draw& draw,
                         std::uint32_t n) {
  const std::vector<Reference> of_points = rounded_references<typename Set::Scalar>(references);
  return test_means(trial, replicate_references(of_points, n),
                    replicate_draws<Set>(StreamKey(trial.seed, trial.claim), of_points, draw, n));
}

/// Every draw equals the reference to within `ulps` units in the last place: an estimator without variance.
template <class Real = double, class Draw>
Finding check_constant(const Trial& trial, double reference, int ulps, const Draw& draw) {
  constexpr std::uint64_t draws = 102'400;
  const double tolerance = ulps * static_cast<double>(ulp<Real>);
  const StreamKey key(trial.seed, trial.claim);
  Finding finding{.verdict = Verdict::certified, .guarantee = Guarantee::deterministic, .margin = tolerance};
  for (std::uint64_t first = 0; first < draws; first += lanes<Real>) {
    PhiloxStream<Real> source(key, 0, first);
    std::array<double, lanes<Real>> values{};
    store_lanes(draw(source), values.data());
    for (double value : values) {
      const double error = value / reference - 1;
      ++finding.draws;
      if (!(std::abs(error) <= std::abs(finding.bias))) finding.bias = error;
      finding.interval = {std::min(finding.interval.lo, error), std::max(finding.interval.hi, error)};
      if (std::abs(error) <= tolerance) continue;
      finding.verdict = Verdict::biased;
      finding.note = "draw " + std::to_string(finding.draws - 1) + " is off by " +
                     std::to_string(error / tolerance * ulps) + " ulp";
      return finding;
    }
  }
  return finding;
}

}  // namespace fairlight

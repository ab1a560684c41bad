#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <fairlight/stats/limits.h>
#include <fairlight/stats/mean_test.h>
#include <fairlight/stats/site.h>

namespace fairlight {

/// An estimator whose draws all lie in [lower, upper].
template <class Estimator>
struct InRange {
  Estimator estimator;
  double lower, upper;

  auto operator()(Generator& generator) { return estimator(generator); }
};

/// Declares the range of an estimator's draws, which is checked at every draw.
template <class Estimator>
InRange<std::decay_t<Estimator>> in_range(Estimator&& estimator, double lower, double upper) {
  return {std::forward<Estimator>(estimator), lower, upper};
}

/// An estimate with the standard error that its estimator states.
struct Estimate {
  double value, standard_error;
};

namespace detail {

/// 1 where a stated interval misses the reference, 0 where it covers it, NaN where it is none (an
/// end is NaN, or the ends are in the wrong order). Of an Estimate, it is the normal interval.
double misses(const Interval& interval, double level, double reference);
double misses(const Estimate& estimate, double level, double reference);

/// Fills channels[c][i] with channel c of draw i. The caller sets the sizes.
using EstimatorDraws = std::function<void(Generator&, Meter&, std::vector<std::vector<double>>& channels)>;

/// Throws std::invalid_argument for a draw of another number of channels than there are references.
void check_channels(std::size_t drawn, std::size_t expected);

template <class Draw>
void store(const Draw& draw, std::vector<std::vector<double>>& channels, std::size_t i) {
  if constexpr (std::is_convertible_v<Draw, double>) {
    check_channels(1, channels.size());
    channels[0][i] = static_cast<double>(draw);
  } else {
    check_channels(static_cast<std::size_t>(draw.size()), channels.size());
    for (std::size_t c = 0; c < channels.size(); ++c)
      channels[c][i] = static_cast<double>(draw[static_cast<decltype(draw.size())>(c)]);
  }
}

/// The draws of an estimator that returns a number, an array or an Eigen vector.
template <class Estimator>
EstimatorDraws draws_of(Estimator& estimator) {
  return [&estimator](Generator& generator, Meter& meter, std::vector<std::vector<double>>& channels) {
    for (std::size_t i = 0; i < channels[0].size(); ++i) {
      meter.draw();
      store(estimator(generator), channels, i);
    }
  };
}

/// Half the squared differences of pairs of draws, whose mean is the variance. A draw outside the
/// range throws BadDraw.
EstimatorDraws pair_variances(EstimatorDraws draws, const Interval& range);

/// The number of channels of an estimator; one of dynamic size draws once to say so.
template <class Estimator>
std::size_t channels_of(const Site& site, Estimator& estimator) {
  if constexpr (std::is_convertible_v<decltype(estimator(std::declval<Generator&>())), double>) {
    return 1;
  } else {
    Generator generator = generator_for(trial_at(site, 0.5), "channels");
    return static_cast<std::size_t>(estimator(generator).size());
  }
}

/// The declared range of an estimator; infinite without one.
template <class Estimator>
Interval range_of(const Estimator&) {
  return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
}
template <class Estimator>
Interval range_of(const InRange<Estimator>& estimator) {
  return {estimator.lower, estimator.upper};
}

/// One reference for each channel, from numbers or References.
inline Reference reference_of(const Reference& reference) { return reference; }
inline Reference reference_of(double mean) {
  return {mean, -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), 0,
          std::abs(mean)};
}
template <class References>
std::vector<Reference> references_of(const References& references) {
  if constexpr (requires { reference_of(references); }) {
    return {reference_of(references)};
  } else {
    std::vector<Reference> all;
    for (const auto& reference : references) all.push_back(reference_of(reference));
    return all;
  }
}

}  // namespace detail
}  // namespace fairlight

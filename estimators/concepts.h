#pragma once

#include <concepts>

#include <fairlight/estimators/bound.h>
#include <fairlight/estimators/density.h>
#include <fairlight/estimators/vec.h>

namespace fairlight {

/// A source of numbers in [0,1), one dimension after another.
template <class Source, class Real>
concept UniformSource = requires(Source source) {
  { source.next() } -> std::convertible_to<Real>;
};

/// The next two dimensions of a source. If the source stratifies pairs, this is one of its pairs.
template <class Real, UniformSource<Real> Source>
Vec2<Real> next_pair(Source& source) {
  if constexpr (requires { source.pair(); }) {
    const auto pair = source.pair();
    return {pair[0], pair[1]};
  }
  const Real first = source.next();
  return {first, source.next()};
}

/// A distribution on some space. `sample(u)` is a pure function of a point of the unit square;
/// `pdf(x)` is its density.
template <class T>
concept Sampler = requires(const T sampler, typename T::Point x, Vec2<typename T::Scalar> u) {
  { sampler.sample(u) } -> std::convertible_to<typename T::Point>;
  { sampler.pdf(x) } -> std::same_as<Density<typename T::Measure, typename T::Scalar>>;
};

/// `estimate(source)` is one draw of a random variable, whose mean is the claim.
template <class T, class Source>
concept Estimator = requires(const T estimator, Source source) {
  estimator.estimate(source);
};

/// An estimator that knows a bound on its draws. Combinators compute theirs from the bounds of
/// their parts.
template <class T>
concept Bounded = requires(const T estimator) {
  { estimator.bound() } -> std::same_as<Bound>;
};

}  // namespace fairlight

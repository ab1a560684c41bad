#pragma once

#include <utility>

#include <fairlight/estimators/concepts.h>

namespace fairlight {

/// What roulette decided: whether to go on, and what the rest is then worth.
template <class Real>
struct Survival {
  Mask<Real> alive;
  Real weight;
};

/// Goes on with probability q, and pays for it with 1/q.
/// Domain   q in [0,1]; q = 0 never goes on, q = 1 always does
/// Random   one number u in [0,1)
/// Source   Arvo and Kirk 1990; the paper, 3.2.1
struct RussianRoulette {
  template <class Real>
  static Survival<Real> play(Real q, Real u) {
    return {u < q, Real(1) / q};
  }
};

/// An estimator that is run with probability q and counted 1/q times: the same mean. Bound: the estimator's over q.
/// Source   Arvo and Kirk 1990
template <class Inner, class Real, class Roulette = RussianRoulette>
class Rouletted {
 public:
  Rouletted(Inner inner, Real q) : inner_(std::move(inner)), q_(q) {}

  template <UniformSource<Real> Source>
  auto estimate(Source& source) const {
    const auto [alive, weight] = Roulette::template play<Real>(q_, source.next());
    using Value = decltype(inner_.estimate(source));
    if (!any(alive)) return zero<Value>();
    return select(alive, Value(inner_.estimate(source) * weight), zero<Value>());
  }

 private:
  Inner inner_;
  Real q_;
};

/// A path goes on with the largest of the surface's three reflectances, so black absorbs and white reflects.
/// Bound: the throughput never exceeds 1 with cosine-weighted bounces.
/// Source   the paper, 3.2.1
template <class Roulette = RussianRoulette>
struct RouletteByReflectance {
  template <class Real, UniformSource<Real> Source>
  static Survival<Real> play(const Rgb<Real>& albedo, Source& source) {
    return Roulette::template play<Real>(max_channel(albedo), source.next());
  }
};

/// Every path goes on, to the maximum depth: the sum of the terms up to there.
/// Source   the paper, 3.2.1 ("truncated light paths after a fixed depth")
struct NoRoulette {
  template <class Real, UniformSource<Real> Source>
  static Survival<Real> play(const Rgb<Real>&, Source&) {
    return {Mask<Real>(true), Real(1)};
  }
};

}  // namespace fairlight

#pragma once

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fairlight/estimators/concepts.h>

namespace fairlight {

/// The result of roulette: whether the path goes on, and the weight of the survivor.
template <class Real>
struct Survival {
  Mask<Real> alive;
  Real weight;
};

/// Goes on with probability q, and then multiplies by 1/q.
/// Domain   q in [0,1]; q = 0 never goes on, q = 1 always does. Throws std::invalid_argument
///          elsewhere, as q > 1 would give survivors too small a weight
/// Random   one number u in [0,1)
/// Source   Arvo and Kirk 1990; the paper, 3.2.1
struct RussianRoulette {
  template <class Real>
  static Survival<Real> play(Real q, Real u) {
    if (!all_within(q, 0, 1))
      throw std::invalid_argument("a path cannot go on with such a probability (it must be in [0,1])");
    return {u < q, Real(1) / q};
  }
};

/// Runs an estimator with probability q, and multiplies it by 1/q. The mean stays the same.
/// Domain   q in (0,1]; throws std::invalid_argument elsewhere, as q = 0 would lose the mean
/// Random   one dimension, and those of the estimator if it runs
/// Bound    the estimator's over q, or 0
/// Source   Arvo and Kirk 1990
template <class Inner, class Roulette = RussianRoulette>
class Rouletted {
 public:
  using Scalar = typename Inner::Scalar;

  Rouletted(Inner inner, double q) : inner_(std::move(inner)), q_(q) {
    if (!all_positive(q) || !(q <= 1))
      throw std::invalid_argument("a probability must be in (0,1] (survivors are paid 1/q)");
  }

  template <UniformSource<Scalar> Source>
  auto estimate(Source& source) const {
    const auto [alive, weight] = Roulette::template play<Scalar>(rounded<Scalar>(q_), source.next());
    using Value = decltype(inner_.estimate(source));
    if (!any(alive)) return zero<Value>();
    return select(alive, Value(inner_.estimate(source) * weight), zero<Value>());
  }

  Bound bound() const { return or_nothing(1 / q_ * inner_.bound()); }

 private:
  Inner inner_;
  double q_;
};

/// Roulettes of a path. Before each bounce the tracer calls `play(albedo, throughput, depth,
/// source)` with the reflectance at the vertex, the throughput of the path there, and the number of
/// bounces so far. They have no `bound()`: the throughput also depends on how much a bounce may
/// weigh, which the scene and its direction samplers decide.

/// Goes on with probability equal to the largest channel of the surface's reflectance. So black
/// absorbs, and white always reflects.
/// Random   one dimension
/// Bound    the throughput never exceeds 1 with cosine-weighted bounces
/// Source   the paper, 3.2.1
template <class Roulette = RussianRoulette>
struct RouletteByReflectance {
  template <class Real, UniformSource<Real> Source>
  static Survival<Real> play(const Rgb<Real>& albedo, const Rgb<Real>&, const Real&, Source& source) {
    return Roulette::template play<Real>(max_channel(albedo), source.next());
  }
};

/// Goes on with probability min(1, largest channel of throughput times albedo), the throughput
/// after a bounce of weight albedo. Survivors of q < 1 then carry 1, so no work goes into paths of
/// small weight.
/// Random   one dimension
/// Bound    if every bounce weighs at most w times the albedo: afterwards a path carries at most w,
///          or w albedo times its throughput
/// Source   Arvo and Kirk 1990; Pharr, Jakob, Humphreys, PBR 4ed, 13.4
template <class Roulette = RussianRoulette>
struct RouletteByThroughput {
  template <class Real, UniformSource<Real> Source>
  static Survival<Real> play(const Rgb<Real>& albedo, const Rgb<Real>& throughput, const Real&, Source& source) {
    using std::min;
    const Real q = min(Real(1), max_channel(Rgb<Real>(throughput * albedo)));
    return Roulette::template play<Real>(q, source.next());
  }
};

/// Plays another roulette from bounce number `first` on. All paths make the earlier bounces, as
/// these carry most of a picture.
/// Domain   bounces count from 1; throws std::invalid_argument for a `first` below 1
/// Random   that of the other roulette, at earlier bounces too: a lane's numbers must not depend on
///          the depths of the other lanes
/// Bound    that of the other roulette, times the weights of the earlier bounces if these exceed 1
/// Source   Mitsuba 3, rr_depth ("may randomly cease after encountering directly visible surfaces":
///          1)
template <class Roulette>
class RouletteFromBounce {
 public:
  explicit RouletteFromBounce(int first, Roulette roulette = Roulette()) : first_(first), roulette_(roulette) {
    if (first < 1)
      throw std::invalid_argument("a path's first bounce is number 1 (roulette cannot begin before it)");
  }

  template <class Real, UniformSource<Real> Source>
  Survival<Real> play(const Rgb<Real>& albedo, const Rgb<Real>& throughput, const Real& depth,
                      Source& source) const {
    const Mask<Real> spared = depth < rounded<Real>(first_ - 1);
    const auto [alive, weight] = roulette_.template play<Real>(albedo, throughput, depth, source);
    return {alive || spared, select(spared, Real(1), weight)};
  }

 private:
  int first_;
  Roulette roulette_;
};

/// All paths go on to the maximum depth: the sum of the terms up to there.
/// Source   the paper, 3.2.1 ("truncated light paths after a fixed depth")
struct NoRoulette {
  template <class Real, UniformSource<Real> Source>
  static Survival<Real> play(const Rgb<Real>&, const Rgb<Real>&, const Real&, Source&) {
    return {Mask<Real>(true), Real(1)};
  }
};

}  // namespace fairlight

#pragma once

#include <algorithm>
#include <stdexcept>
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
/// Domain   q in [0,1]; q = 0 never goes on, q = 1 always does. Throws std::invalid_argument elsewhere: survivors of a q above 1
///          would be paid too little
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

/// An estimator that is run with probability q and counted 1/q times: the same mean.
/// Domain   q in (0,1]; throws std::invalid_argument elsewhere, as with q = 0 there is no mean left
/// Random   one dimension, and those of the estimator where it is run
/// Bound    the estimator's over q, or nothing
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

/// The roulettes of a path are asked before each bounce: `play(albedo, throughput, depth, source)`, with the reflectance
/// where the path is, what it carries there, and how many bounces it has made. They have no `bound()` of their own: theirs is one
/// of what a path carries, and how much a bounce may weigh is the scene's to know, and its directions'.

/// A path goes on with the largest of the surface's three reflectances, so black absorbs and white reflects.
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

/// A path goes on with the largest channel of what it will carry after a bounce that weighs the albedo, where that is below 1:
/// survivors then carry 1, so that no work is spent on what hardly counts.
/// Random   one dimension
/// Bound    where no bounce weighs more than w times the albedo, a path carries at most w afterwards, or w albedo times what it did
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

/// Another roulette, but for the bounces before one of a given number, which all paths make: the first ones carry most of a picture.
/// Domain   bounces are counted from 1; throws std::invalid_argument for a first one below that
/// Random   that of the other, before its first bounce too: what a lane draws next must not hang on where the others are
/// Bound    that of the other, times what the bounces before it weigh, if that is above 1
/// Source   Mitsuba 3, rr_depth ("may randomly cease after encountering directly visible surfaces": 1)
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

/// Every path goes on, to the maximum depth: the sum of the terms up to there.
/// Source   the paper, 3.2.1 ("truncated light paths after a fixed depth")
struct NoRoulette {
  template <class Real, UniformSource<Real> Source>
  static Survival<Real> play(const Rgb<Real>&, const Rgb<Real>&, const Real&, Source&) {
    return {Mask<Real>(true), Real(1)};
  }
};

}  // namespace fairlight

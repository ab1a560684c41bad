#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include <fairlight/estimators/long_sum.h>
#include <fairlight/estimators/pick_one.h>
#include <fairlight/estimators/safe_divide.h>

namespace fairlight {

/// Chooses one of n alternatives in proportion to fixed weights, such as the powers of lights.
/// Never chooses an alternative of weight 0. If all weights are 0, or n = 0, there is no choice,
/// and the pick has probability 0.
/// Formula  P(i) = w_i / sum w
/// Measure  discrete
/// Domain   0 .. n-1, n from 0 to 2^24; w_i >= 0 and finite (else std::invalid_argument)
/// Random   u in [0,1)^2; u_y refines u_x
/// Source   Shirley, Wang, Zimmerman 1996, 5; Devroye 1986, III.2 (inversion)
template <class Real>
class PowerChoice {
  // Binary search of the cumulative weights. The comparison uses both random numbers, which
  // together resolve 2^48 parts in floats.
 public:
  explicit PowerChoice(const std::vector<double>& weights) : size_(static_cast<int>(weights.size())) {
    if (weights.size() > 1u << 24)
      throw std::invalid_argument("a choice among more than 2^24 (a float cannot count them)");
    double total = 0;
    std::size_t chosen = 0;  // one past the last alternative of positive weight
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (!all_nonnegative(weights[i]))
        throw std::invalid_argument("a weight must be nonnegative and finite (it becomes a probability)");
      total += weights[i];
      if (weights[i] > 0) chosen = i + 1;
    }
    if (!all_finite(total)) throw std::invalid_argument("the sum of the weights must be finite (scale them down)");
    while (1 << steps_ < size_) ++steps_;
    upper_.assign(std::size_t{1} << steps_, Number(2));
    lower_.assign(std::size_t{1} << steps_, Number(0));
    probabilities_.assign(std::max<std::size_t>(1, weights.size()), Number(0));
    double sum = 0;
    for (std::size_t i = 0; i < chosen; ++i) {
      probabilities_[i] = static_cast<Number>(weights[i] / total);
      sum += weights[i];
      if (i + 1 < chosen) cut(i, sum / total);
    }
  }

  int size() const { return size_; }

  /// P(i).
  Real probability(const Index<Real>& i) const { return gather(probabilities_.data(), i); }

  Pick<Real> sample(const Vec2<Real>& u) const {
    Real index(0);
    for (int step = 1 << steps_ >> 1; step > 0; step >>= 1) {
      const Index<Real> middle = to_int(Real(index + rounded<Real>(step - 1)));
      const Real upper = gather(upper_.data(), middle);
      const Mask<Real> equal = upper == u.x();
      Mask<Real> passed = upper < u.x();
      if (any(equal)) passed = passed || (equal && gather(lower_.data(), middle) <= u.y());
      index += select(passed, rounded<Real>(step), Real(0));
    }
    return {to_int(index), Density<Discrete, Real>(gather(probabilities_.data(), to_int(index)))};
  }

 private:
  using Number = Lane<Real>;

  // Alternative i ends at x. `upper_` is x rounded down to a multiple of ulp/2, to compare with
  // u_x; `lower_` is the rest in units of ulp/2, to compare with u_y.
  void cut(std::size_t i, double x) {
    const double steps = x * 2 / static_cast<double>(ulp<Real>);
    upper_[i] = static_cast<Number>(std::floor(steps)) * ulp<Real> / 2;
    lower_[i] = static_cast<Number>(steps - std::floor(steps));
  }

  int size_;
  int steps_ = 0;
  std::vector<Number> upper_, lower_, probabilities_;
};

/// Chooses one of n alternatives in proportion to weight(i), such as what light i may contribute at
/// a point. weight(i) must be positive wherever term i is not 0. If all weights are 0, or n = 0,
/// there is no choice, and the pick has probability 0.
/// Formula  P(i) = weight(i) / sum over k of weight(k)
/// Measure  discrete
/// Domain   0 .. n-1, n from 0 to 2^24; sum and weights >= 0, finite (else std::invalid_argument)
/// Random   u in [0,1)^2; u_y refines u_x
/// Source   Shirley, Wang, Zimmerman 1996, 5
template <class Real, class Weight>
class ContributionChoice {
  // Each pick evaluates every weight twice, so it costs O(n). In floats, an alternative is chosen
  // with its returned probability to (n + 1) 2^-46, and that probability is the formula's to a
  // relative (n 2^-24)^2, since the sums have two parts.
 public:
  ContributionChoice(int n, Weight weight) : n_(n), weight_(std::move(weight)) {
    if (n < 0) throw std::invalid_argument("a choice among fewer than no alternatives (their number is negative)");
    if (n > 1 << 24) throw std::invalid_argument("a choice among more than 2^24 (a float cannot count them)");
  }

  int size() const { return n_; }

  /// P(i). `weight` must accept a different i in each lane. 0 if all weights are 0.
  Real probability(const Index<Real>& i) const {
    const Real sum = sum_of_weights().value();
    return weight_(i) / select(sum > Real(0), sum, Real(1));
  }

  /// Finds the last alternative of positive weight for which the sum of all weights before it is at
  /// most the target.
  Pick<Real> sample(const Vec2<Real>& u) const {
    const LongSum<Real> total = sum_of_weights();
    const LongSum<Real> target = part(total, u);
    Real index(0), chosen(0);
    LongSum<Real> before;
    Mask<Real> searching(true);
    for (int i = 0; i < n_ && any(searching); ++i) {
      const Real weight = weight_(i);
      const Mask<Real> reached = searching && weight > Real(0);
      index = select(reached, rounded<Real>(i), index);
      chosen = select(reached, weight, chosen);
      before.add(weight);
      searching = searching && before <= target;
    }
    const Real sum = total.value();
    return {to_int(index), Density<Discrete, Real>(Real(chosen / select(sum > Real(0), sum, Real(1))))};
  }

 private:
  LongSum<Real> sum_of_weights() const {
    LongSum<Real> total;
    Mask<Real> right(true);
    for (int i = 0; i < n_; ++i) {
      const Real weight = weight_(i);
      right = right && weight >= Real(0);
      total.add(weight);
    }
    if (!all(right) || !all_finite(total.value()))
      throw std::invalid_argument("a weight must be nonnegative and finite (it becomes a probability)");
    return total;
  }

  // The fraction u of the sum; u_y refines u_x.
  static LongSum<Real> part(const LongSum<Real>& sum, const Vec2<Real>& u) {
    std::array<double, lanes<Real>> first{}, second{}, high{}, low{};
    store_lanes(u.x(), first.data());
    store_lanes(u.y(), second.data());
    store_lanes(sum.high, high.data());
    store_lanes(sum.low, low.data());
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      first[k] = (first[k] + second[k] * (static_cast<double>(ulp<Real>) / 2)) * (high[k] + low[k]);
    }
    LongSum<Real> part;
    load_lanes(first.data(), part.high);
    store_lanes(part.high, high.data());
    for (std::size_t k = 0; k < lanes<Real>; ++k) low[k] = first[k] - high[k];
    load_lanes(low.data(), part.low);
    return part;
  }

  int n_;
  Weight weight_;
};

/// Estimates a sum of terms from one term, which `Choice` picks: the term over its probability, or
/// 0 if there is none to pick. Unbiased if no nonzero term has probability 0.
/// Bound    the hull of the terms' bounds, each over its probability; [0,0] if no term can be
///          picked
/// Source   Shirley, Wang, Zimmerman 1996, 5; the paper, A.1
template <class Choice>
class LightSampler {
 public:
  explicit LightSampler(Choice choice) : choice_(std::move(choice)) {}

  /// The probability of picking term i.
  template <class Real>
  Real probability(int /*n*/, const Index<Real>& i) const {
    return choice_.probability(i);
  }

  /// Throws std::invalid_argument unless n is the number of alternatives of the choice.
  template <class Real, UniformSource<Real> Source, class Term>
  auto sum(int n, Source& source, const Term& term) const {
    if (n != choice_.size())
      throw std::invalid_argument("a choice among other alternatives (their numbers differ)");
    using Value = decltype(term(Index<Real>(), source));
    const Pick<Real> pick = choice_.sample(next_pair<Real>(source));
    if (!any(pick.probability.value() != Real(0))) return zero<Value>();
    return safe_divide(Value(term(pick.index, source)), pick.probability);
  }

  /// The bound, from the bounds of the terms and the probabilities (or lower bounds of them).
  /// Throws std::invalid_argument unless there is one probability in [0,1] for each term.
  static Bound bound(std::span<const Bound> terms, std::span<const double> probabilities) {
    if (terms.size() != probabilities.size())
      throw std::invalid_argument("terms without a probability, or the other way round (their numbers differ)");
    Bound any{infinity<double>, -infinity<double>};
    for (std::size_t i = 0; i < terms.size(); ++i) {
      const double p = probabilities[i];
      if (!all_within(p, 0, 1)) throw std::invalid_argument("a probability must be in [0,1] (it divides the term)");
      if (p > 0) any = hull(any, 1 / p * terms[i]);
    }
    return any.lower <= any.upper ? any : Bound{0, 0};
  }

 private:
  Choice choice_;
};

}  // namespace fairlight

#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include <fairlight/estimators/existing.h>
#include <fairlight/estimators/pick_one.h>

namespace fairlight {

/// One of n alternatives in proportion to fixed weights, such as the powers of lights. What has no weight has probability
/// 0 and is never chosen; where nothing has any, or there is nothing, the probability of the pick is 0: there is none.
/// A binary search of the cumulative weights, to the last bit of both numbers: those of a float tell 2^48 parts.
/// Formula  P(i) = w_i / sum w
/// Measure  discrete
/// Domain   0 .. n-1, n from 0 to 2^24; w_i >= 0 and finite (throws std::invalid_argument otherwise)
/// Random   u in [0,1)^2: its second number refines the first
/// Source   Shirley, Wang, Zimmerman 1996, 5; Devroye 1986, III.2 (inversion)
template <class Real>
class PowerChoice {
 public:
  explicit PowerChoice(const std::vector<double>& weights) : size_(static_cast<int>(weights.size())) {
    if (weights.size() > 1u << 24)
      throw std::invalid_argument("a choice among more than 2^24 (a float cannot count them)");
    double total = 0;
    std::size_t chosen = 0;  // beyond the last that can be
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (!(weights[i] >= 0 && std::isfinite(weights[i])))
        throw std::invalid_argument("a weight must be nonnegative and finite (it becomes a probability)");
      total += weights[i];
      if (weights[i] > 0) chosen = i + 1;
    }
    if (!std::isfinite(total))
      throw std::invalid_argument("the sum of the weights must be finite (scale them down)");
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

  Pick<Real> sample(const Vec2<Real>& u) const {
    Real index(0);
    for (int step = 1 << steps_ >> 1; step > 0; step >>= 1) {
      const Index<Real> middle = whole(Real(index + rounded<Real>(step - 1)));
      const Real upper = gather(upper_.data(), middle);
      const Mask<Real> passed = upper < u.x() || (upper == u.x() && gather(lower_.data(), middle) <= u.y());
      index += select(passed, rounded<Real>(step), Real(0));
    }
    return {whole(index), Density<Discrete, Real>(gather(probabilities_.data(), whole(index)))};
  }

 private:
  using Number = Lane<Real>;

  // Alternative i ends at x: in steps of a first number, and in [0,1) of such a step.
  void cut(std::size_t i, double x) {
    const double steps = x * 2 / static_cast<double>(ulp<Real>);
    upper_[i] = static_cast<Number>(std::floor(steps)) * ulp<Real> / 2;
    lower_[i] = static_cast<Number>(steps - std::floor(steps));
  }

  int size_;
  int steps_ = 0;
  std::vector<Number> upper_, lower_, probabilities_;
};

/// One of n alternatives in proportion to weights that weight(i) gives, such as what each light may bring to the point at hand,
/// which must be positive wherever what is summed is not 0. Every weight is looked at twice: O(n) a pick. Without any
/// weight, or with nothing to choose from, the probability of the pick is 0: there is none.
/// Formula  P(i) = weight(i) / sum of them
/// Measure  discrete
/// Domain   0 .. n-1, n at least 0; weights nonnegative and finite (throws std::invalid_argument otherwise)
/// Random   u in [0,1)^2: its second number refines the first
/// Source   Shirley, Wang, Zimmerman 1996, 5
template <class Real, class Weight>
class ContributionChoice {
 public:
  ContributionChoice(int n, Weight weight) : n_(n), weight_(std::move(weight)) {
    if (n < 0) throw std::invalid_argument("a choice among fewer than no alternatives");
  }

  int size() const { return n_; }

  /// The sums are of doubles, so that none of many weights is lost among them.
  Pick<Real> sample(const Vec2<Real>& u) const {
    const Lanes total = sum_of_weights();
    Lanes target = fine_number(u), below{}, probabilities{};
    for (std::size_t k = 0; k < lanes<Real>; ++k) target[k] *= total[k];
    std::array<int, lanes<Real>> indices{};
    bool searching = true;
    for (int i = 0; i < n_ && searching; ++i) {
      const Lanes weight = weight_of(i);
      searching = false;
      for (std::size_t k = 0; k < lanes<Real>; ++k) {
        const bool reached = below[k] <= target[k] && weight[k] > 0;
        indices[k] = reached ? i : indices[k];
        probabilities[k] = reached ? weight[k] / total[k] : probabilities[k];
        below[k] += weight[k];
        searching |= below[k] <= target[k];
      }
    }
    Index<Real> index;
    Real probability;
    load_lanes(indices.data(), index);
    load_lanes(probabilities.data(), probability);
    return {index, Density<Discrete, Real>(probability)};
  }

 private:
  using Lanes = std::array<double, lanes<Real>>;

  Lanes weight_of(int i) const {
    Lanes weight{};
    store_lanes(Real(weight_(i)), weight.data());
    return weight;
  }

  Lanes sum_of_weights() const {
    Lanes total{}, least{};
    for (int i = 0; i < n_; ++i) {
      const Lanes weight = weight_of(i);
      for (std::size_t k = 0; k < lanes<Real>; ++k) {
        total[k] += weight[k];
        least[k] = std::min(least[k], weight[k]);
      }
    }
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      if (!(least[k] >= 0 && std::isfinite(total[k])))
        throw std::invalid_argument("a weight must be nonnegative and finite (it becomes a probability)");
    }
    return total;
  }

  int n_;
  Weight weight_;
};

/// The sum of terms from one of them, chosen by `Choice` and divided by its probability; 0 where there is none to choose.
/// Unbiased when no term that is not 0 has probability 0. Bound: the largest of term over probability.
/// Source   Shirley, Wang, Zimmerman 1996, 5; the paper, A.1
template <class Choice>
class OneBy {
 public:
  explicit OneBy(Choice choice) : choice_(std::move(choice)) {}

  /// Of as many terms as the choice has alternatives; throws std::invalid_argument for another number.
  template <class Real, UniformSource<Real> Source, class Term>
  auto sum(int n, Source& source, const Term& term) const {
    if (n != choice_.size())
      throw std::invalid_argument("a choice among other alternatives (their numbers differ)");
    using Value = decltype(term(Index<Real>(), source));
    const Pick<Real> pick = choice_.sample(next_pair<Real>(source));
    if (!any(pick.probability.value() != Real(0))) return zero<Value>();
    return over_existing(Value(term(pick.index, source)), pick.probability);
  }

 private:
  Choice choice_;
};

}  // namespace fairlight

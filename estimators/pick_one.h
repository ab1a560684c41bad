#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>

#include <fairlight/estimators/concepts.h>
#include <fairlight/estimators/packet_words.h>

namespace fairlight {

/// The alternative that was chosen, and its probability.
template <class Real>
struct Pick {
  Index<Real> index;
  Density<Discrete, Real> probability;
};

/// Chooses one of n alternatives uniformly, to a relative n / 2^48 of the probability.
/// Formula  P(i) = 1/n
/// Measure  discrete
/// Domain   0 .. n-1, n from 1 to 2^24 (throws std::invalid_argument otherwise)
/// Random   u in [0,1)^2; u_y refines u_x
/// Source   the paper, A.1; Lemire 2019, "Fast random integer generation in an interval" (by
///          multiplication)
template <class Real>
class UniformChoice {
  // The integer part of n U, where U has 48 bits: the first 24 of each number. The 24 bits of one
  // float cannot choose evenly among 10^5.
 public:
  explicit UniformChoice(int n) : n_(n) {
    if (n < 1) throw std::invalid_argument("a choice among no alternatives (give at least one)");
    if (n > 1 << 24) throw std::invalid_argument("a choice among more than 2^24 (a float cannot count them)");
  }

  Pick<Real> sample(const Vec2<Real>& u) const {
    const auto n = static_cast<std::uint32_t>(n_);
    const auto [high, low] = multiply_high_low(n, leading_bits(u.x()));
    const Word<Real> finer = multiply_high_low(n, leading_bits(u.y()))[0] << 8;
    const Word<Real> carry = select(low + finer < low, Word<Real>(1u), Word<Real>(0u));
    return {index_of(high + carry), Density<Discrete, Real>(Real(1) / rounded<Real>(n_))};
  }

 private:
  int n_;
};

/// Sums all n terms, each estimated: term(i, source) for every i; 0 if n = 0.
/// Bound    the sum of the terms' bounds
/// Source   the paper, A.1 ("one random point from each of the luminaires")
struct AllLights {
  /// The probability of evaluating term i.
  template <class Real>
  static Real probability(int /*n*/, const Index<Real>& /*i*/) {
    return Real(1);
  }

  template <class Real, UniformSource<Real> Source, class Term>
  static auto sum(int n, Source& source, const Term& term) {
    auto total = zero<decltype(term(0, source))>();
    for (int i = 0; i < n; ++i) total += term(i, source);
    return total;
  }

  /// The bound, from those of the terms.
  static Bound bound(std::span<const Bound> terms) {
    Bound total{0, 0};
    for (const Bound& term : terms) total = total + term;
    return total;
  }
};

/// Estimates the sum of n terms from one, chosen uniformly and divided by its probability 1/n; 0 if
/// n = 0.
/// Bound    n times the hull of the terms' bounds
/// Source   the paper, A.1 (the two-dice argument)
struct UniformLightSampler {
  /// The probability of picking term i.
  template <class Real>
  static Real probability(int n, const Index<Real>& /*i*/) {
    return Real(1) / rounded<Real>(n);
  }

  template <class Real, UniformSource<Real> Source, class Term>
  static auto sum(int n, Source& source, const Term& term) {
    using Value = decltype(term(Index<Real>(), source));
    if (n == 0) return zero<Value>();
    const Pick<Real> pick = UniformChoice<Real>(n).sample(next_pair<Real>(source));
    return Value(term(pick.index, source) / pick.probability);
  }

  /// The bound, from those of the terms.
  static Bound bound(std::span<const Bound> terms) {
    if (terms.empty()) return {0, 0};
    Bound any = terms.front();
    for (const Bound& term : terms) any = hull(any, term);
    return static_cast<double>(terms.size()) * any;
  }
};

}  // namespace fairlight

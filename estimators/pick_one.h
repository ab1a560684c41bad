#pragma once

#include <stdexcept>

#include <fairlight/estimators/concepts.h>

namespace fairlight {

/// One of n alternatives, each as likely as the others.
/// Formula  P(i) = 1/n
/// Measure  discrete
/// Domain   0 .. n-1, n at least 1 (throws std::invalid_argument otherwise)
/// Random   one number u in [0,1)
/// Source   the paper, A.1
template <class Real>
class UniformChoice {
 public:
  struct Pick {
    Index<Real> index;
    Density<Discrete, Real> probability;
  };

  explicit UniformChoice(int n) : n_(n) {
    if (n < 1) throw std::invalid_argument("a choice among no alternatives (give at least one)");
  }

  Pick sample(Real u) const {
    return {whole(u * rounded<Real>(n_)), Density<Discrete, Real>(Real(1) / rounded<Real>(n_))};
  }

 private:
  int n_;
};

/// The sum of n >= 1 terms, each estimated: term(i, source) for every i. Bound: the sum of the terms' bounds.
/// Source   the paper, A.1 ("one random point from each of the luminaires")
struct AllOf {
  template <class Real, UniformSource<Real> Source, class Term>
  static auto sum(int n, Source& source, const Term& term) {
    auto total = term(0, source);
    for (int i = 1; i < n; ++i) total += term(i, source);
    return total;
  }
};

/// The sum of n >= 1 terms from one of them, chosen uniformly and divided by its probability: |L| times the term.
/// Bound: n times the largest of the terms' bounds.
/// Source   the paper, A.1 (the two-dice argument)
struct OneOf {
  template <class Real, UniformSource<Real> Source, class Term>
  static auto sum(int n, Source& source, const Term& term) {
    const auto pick = UniformChoice<Real>(n).sample(source.next());
    using Value = decltype(term(pick.index, source));
    return Value(term(pick.index, source) / pick.probability);
  }
};

}  // namespace fairlight

#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include <fairlight/estimators/concepts.h>

namespace fairlight {

/// What was chosen, and with what probability.
template <class Real>
struct Pick {
  Index<Real> index;
  Density<Discrete, Real> probability;
};

/// Two numbers as one of 48 bits, the first 24 of each: a float's 24 alone cannot choose evenly among 10^5.
template <class Real>
std::array<double, lanes<Real>> fine_number(const Vec2<Real>& u) {
  std::array<double, lanes<Real>> upper{}, lower{};
  store_lanes(u.x(), upper.data());
  store_lanes(u.y(), lower.data());
  for (std::size_t i = 0; i < lanes<Real>; ++i) {
    upper[i] = (std::floor(upper[i] * 0x1p24) + std::floor(lower[i] * 0x1p24) * 0x1p-24) * 0x1p-24;
  }
  return upper;
}

/// One of n alternatives, each as likely as the others, to n / 2^48 of its probability.
/// Formula  P(i) = 1/n
/// Measure  discrete
/// Domain   0 .. n-1, n at least 1 (throws std::invalid_argument otherwise)
/// Random   u in [0,1)^2: its second number refines the first
/// Source   the paper, A.1
template <class Real>
class UniformChoice {
 public:
  explicit UniformChoice(int n) : n_(n) {
    if (n < 1) throw std::invalid_argument("a choice among no alternatives (give at least one)");
  }

  Pick<Real> sample(const Vec2<Real>& u) const {
    const auto numbers = fine_number(u);
    std::array<int, lanes<Real>> indices{};
    for (std::size_t i = 0; i < lanes<Real>; ++i) indices[i] = static_cast<int>(numbers[i] * n_);
    Index<Real> index;
    load_lanes(indices.data(), index);
    return {index, Density<Discrete, Real>(Real(1) / rounded<Real>(n_))};
  }

 private:
  int n_;
};

/// The sum of n terms, each estimated: term(i, source) for every i; 0 where there are none. Bound: the sum of the terms'
/// bounds.
/// Source   the paper, A.1 ("one random point from each of the luminaires")
struct AllOf {
  template <class Real, UniformSource<Real> Source, class Term>
  static auto sum(int n, Source& source, const Term& term) {
    auto total = zero<decltype(term(0, source))>();
    for (int i = 0; i < n; ++i) total += term(i, source);
    return total;
  }
};

/// The sum of n terms from one of them, chosen uniformly and divided by its probability: |L| times the term; 0 where there
/// are none.
/// Bound: n times the largest of the terms' bounds.
/// Source   the paper, A.1 (the two-dice argument)
struct OneOf {
  template <class Real, UniformSource<Real> Source, class Term>
  static auto sum(int n, Source& source, const Term& term) {
    using Value = decltype(term(Index<Real>(), source));
    if (n == 0) return zero<Value>();
    const Pick<Real> pick = UniformChoice<Real>(n).sample(next_pair<Real>(source));
    return Value(term(pick.index, source) / pick.probability);
  }
};

}  // namespace fairlight

#pragma once

#include <algorithm>
#include <vector>

#include <fairlight/estimators/choose_light.h>
#include <fairlight/estimators/mis.h>
#include <fairlight/estimators/roulette.h>
#include <fairlight/estimators/splitting.h>
#include <fairlight/estimators/stratification.h>

/// Combinators that are wrong in a part of their domain alone.
namespace fairlight::faults {

/// Goes on with a probability of at most 0.95, as many renderers do, but divides by what it was
/// before.
struct RouletteCappedUnpaid {
  template <class Real>
  static Survival<Real> play(Real q, Real u) {
    using std::min;
    return {u < min(q, rounded<Real>(0.95)), Real(1) / q};
  }
};

/// Leaves out the run that the fraction of k stands for.
template <class Inner>
class FractionLost : public Splitting<Inner> {
 public:
  FractionLost(const Inner& inner, double k) : Splitting<Inner>(inner, k), inner_(inner), k_(k) {}
  auto estimate(auto& source) const {
    using Real = typename Inner::Scalar;
    Real sum(0);
    for (int run = 0; run < to_int(k_); ++run) sum += inner_.estimate(source);
    return Real(sum / rounded<Real>(k_));
  }

 private:
  Inner inner_;
  double k_;
};

/// Counts a negative run as 0, as light is never negative.
template <class Inner>
class NegativeRunsCut : public Splitting<Inner> {
 public:
  using Splitting<Inner>::Splitting;
  auto estimate(auto& source) const {
    using std::max;
    using Real = typename Inner::Scalar;
    return Real(max(Real(Splitting<Inner>::estimate(source)), Real(0)));
  }
};

/// A grid of as many rows as columns, whatever was asked for: the rest of the square has no points.
template <class Inner>
class RowsOfColumns : public StratifiedMean<Inner> {
 public:
  RowsOfColumns(const Inner& inner, int columns, int rows)
      : StratifiedMean<Inner>(inner, columns, rows),
        inner_(inner),
        columns_(columns),
        rows_(rows),
        visited_(std::min(rows, columns)) {}
  auto estimate(auto& source) const {
    using Real = typename Inner::Scalar;
    Real sum(0);
    for (int row = 0; row < visited_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        const Real x = source.next();
        Pair<Real> pair{in_cell(column, columns_, x), in_cell(row, rows_, Real(source.next()))};
        sum += inner_.estimate(pair);
      }
    }
    return Real(sum / rounded<Real>(columns_ * visited_));
  }

 private:
  template <class Real>
  struct Pair {
    Real first, second;
    bool used = false;
    Real next() { return std::exchange(used, true) ? second : first; }
  };

  Inner inner_;
  int columns_, rows_, visited_;
};

/// Gives all weight to the largest, and to each of those that tie.
struct EachOfATie {
  template <class Measure, class Real, std::size_t N>
  static Real weight(const std::array<Real, N>& n, const std::array<Density<Measure, Real>, N>& p, std::size_t i) {
    Mask<Real> largest = p[i].value() != Real(0);
    for (std::size_t k = 0; k < N; ++k) largest = largest && !(n[i] * p[i].value() < n[k] * p[k].value());
    return select(largest, Real(1), Real(0));
  }
  static double excess(std::size_t laws) { return MaximumHeuristic::excess(laws); }
};

/// Takes a law that has the density of an earlier one for the same, and leaves it out of the sum.
struct TwinsCountedOnce {
  template <class Measure, class Real, std::size_t N>
  static Real weight(const std::array<Real, N>& n, const std::array<Density<Measure, Real>, N>& p, std::size_t i) {
    Real sum(0);
    for (std::size_t k = 0; k < N; ++k) {
      Mask<Real> is_new(true);
      for (std::size_t j = 0; j < k; ++j) is_new = is_new && p[j].value() != p[k].value();
      sum += select(is_new, Real(n[k] * p[k].value()), Real(0));
    }
    const Mask<Real> exists = p[i].value() > Real(0);
    return select(exists, Real(n[i] * p[i].value() / select(exists, sum, Real(1))), Real(0));
  }
  static double excess(std::size_t) { return 2; }
};

namespace detail {

inline std::vector<double> without_last(std::vector<double> weights) {
  if (weights.size() > 1) weights.back() = 0;
  return weights;
}

inline std::vector<double> without_faint(std::vector<double> weights) {
  const double least = 1e-4 * *std::max_element(weights.begin(), weights.end());
  for (double& weight : weights) weight = weight < least ? 0 : weight;
  return weights;
}

}  // namespace detail

/// A table of lights that ends one too early.
template <class Real>
struct LastLightLost : PowerChoice<Real> {
  explicit LastLightLost(const std::vector<double>& weights) : PowerChoice<Real>(detail::without_last(weights)) {}
};

/// Rounds small probabilities to 0.
template <class Real>
struct FaintLightsLost : PowerChoice<Real> {
  explicit FaintLightsLost(const std::vector<double>& weights)
      : PowerChoice<Real>(detail::without_faint(weights)) {}
};

}  // namespace fairlight::faults

#pragma once

#include <fairlight/estimators/control_variate.h>
#include <fairlight/estimators/mis.h>
#include <fairlight/estimators/splitting.h>
#include <fairlight/estimators/stratification.h>

/// Wrong combinators, which stand in for the right ones through the same template parameters.
namespace fairlight::faults {

/// The first law's weight is squared, the others' are not: they do not sum to one.
/// On record: the class of mitsuba aa325039f and Moer #59.
struct PowerOnOneSide {
  template <class Measure, class Real, std::size_t N>
  static Real weight(const std::array<Real, N>& n, const std::array<Density<Measure, Real>, N>& p, std::size_t i) {
    return i == 0 ? PowerHeuristic::weight(n, p, i) : BalanceHeuristic::weight(n, p, i);
  }
  static double excess(std::size_t laws) { return PowerHeuristic::excess(laws); }
};

/// As many draws as asked for, but counted as if each law gave one: f / sum p_k. On record: the class of appleseed #1515.
struct CountsIgnored {
  template <class Measure, class Real, std::size_t N>
  static Real weight(const std::array<Real, N>& n, const std::array<Density<Measure, Real>, N>& p, std::size_t i) {
    std::array<Real, N> ones;
    ones.fill(Real(1));
    return n[i] * BalanceHeuristic::weight(ones, p, i);
  }
  static double excess(std::size_t laws) { return BalanceHeuristic::excess(laws); }
};

/// The probability of the law that was chosen is not divided by. On record: the class of LuxCore #68.
struct SelectionUnpaid {
  template <class Measure, class Real, std::size_t N>
  static Real weight(const std::array<Real, N>& c, const std::array<Density<Measure, Real>, N>& p, std::size_t i) {
    return c[i] * BalanceHeuristic::weight(c, p, i);
  }
  static double excess(std::size_t laws) { return BalanceHeuristic::excess(laws); }
};

/// The integral of the control is taken away once more, not added.
template <class Inner, class Control>
struct WrongSign : ControlVariate<Inner, Control> {
  WrongSign(const Inner& inner, const Control& control, double c, double mean)
      : ControlVariate<Inner, Control>(inner, control, c, -mean) {}
};

/// The integral of the control is added without the factor that the control has.
template <class Inner, class Control>
struct FactorForgotten : ControlVariate<Inner, Control> {
  FactorForgotten(const Inner& inner, const Control& control, double c, double mean)
      : ControlVariate<Inner, Control>(inner, control, c, mean / c) {}
};

/// The sum of the runs, not their mean. On record: the class of appleseed #1515 and mitsuba3 #1861.
template <class Inner>
class UnpaidSplitting : public Splitting<Inner> {
 public:
  UnpaidSplitting(const Inner& inner, double k) : Splitting<Inner>(inner, k), k_(k) {}
  auto estimate(auto& source) const {
    return Splitting<Inner>::estimate(source) * rounded<typename Inner::Scalar>(k_);
  }

 private:
  double k_;
};

/// The jitter reaches over half of each cell. On record: the class of pbrt-v3 #319, a hole in the samples.
template <class Inner>
class HalfJitter : public StratifiedMean<Inner> {
 public:
  using StratifiedMean<Inner>::StratifiedMean;
  auto estimate(auto& source) const {
    Halved<std::remove_cvref_t<decltype(source)>> halved{source};
    const auto mean = StratifiedMean<Inner>::estimate(halved);
    source = halved.numbers;
    return mean;
  }

 private:
  template <class Source>
  struct Halved {
    Source numbers;
    auto next() { return typename Inner::Scalar(numbers.next() * typename Inner::Scalar(0.5f)); }
  };
};

}  // namespace fairlight::faults

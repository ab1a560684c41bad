#pragma once

#include <fairlight/estimators/control_variate.h>
#include <fairlight/estimators/mis.h>
#include <fairlight/estimators/pick_one.h>
#include <fairlight/estimators/roulette.h>
#include <fairlight/estimators/splitting.h>
#include <fairlight/estimators/stratification.h>

/// Wrong combinators. They replace the right ones through the same template parameters.
namespace fairlight::faults {

/// Squares the weight of the first law but not those of the others, so that they do not sum to one.
/// On record: the class of mitsuba aa325039f and Moer #59.
struct PowerOnOneSide {
  template <class Measure, class Real, std::size_t N>
  static Real weight(const std::array<Real, N>& n, const std::array<Density<Measure, Real>, N>& p, std::size_t i) {
    return i == 0 ? PowerHeuristic::weight(n, p, i) : BalanceHeuristic::weight(n, p, i);
  }
  static double excess(std::size_t laws) { return PowerHeuristic::excess(laws); }
};

/// Takes the requested number of draws from each law, but weights as if each gave one: f / sum p_k.
/// On record: the class of appleseed #1515.
struct CountsIgnored {
  template <class Measure, class Real, std::size_t N>
  static Real weight(const std::array<Real, N>& n, const std::array<Density<Measure, Real>, N>& p, std::size_t i) {
    std::array<Real, N> ones;
    ones.fill(Real(1));
    return n[i] * BalanceHeuristic::weight(ones, p, i);
  }
  static double excess(std::size_t laws) { return BalanceHeuristic::excess(laws); }
};

/// Does not divide by the probability of the chosen law.
/// On record: the class of LuxCore #68.
struct SelectionUnpaid {
  template <class Measure, class Real, std::size_t N>
  static Real weight(const std::array<Real, N>& c, const std::array<Density<Measure, Real>, N>& p, std::size_t i) {
    return c[i] * BalanceHeuristic::weight(c, p, i);
  }
  static double excess(std::size_t laws) { return BalanceHeuristic::excess(laws); }
};

/// Subtracts the integral of the control instead of adding it.
template <class Inner, class Control>
struct WrongSign : ControlVariate<Inner, Control> {
  WrongSign(const Inner& inner, const Control& control, double c, double mean)
      : ControlVariate<Inner, Control>(inner, control, c, -mean) {}
};

/// Adds the integral of the control without the factor of the control.
template <class Inner, class Control>
struct FactorForgotten : ControlVariate<Inner, Control> {
  FactorForgotten(const Inner& inner, const Control& control, double c, double mean)
      : ControlVariate<Inner, Control>(inner, control, c, mean / c) {}
};

/// Cuts negative draws at 0, as if they were errors. The mean of the others is too large.
template <class Inner, class Control>
struct NegativeDrawsCut : ControlVariate<Inner, Control> {
  using ControlVariate<Inner, Control>::ControlVariate;
  auto estimate(auto& source) const {
    using Real = typename Inner::Scalar;
    const Real draw = ControlVariate<Inner, Control>::estimate(source);
    return Real(select(draw > Real(0), draw, Real(0)));
  }
};

/// Gives the sum of the runs, not their mean.
/// On record: the class of appleseed #1515 and mitsuba3 #1861.
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

/// Jitters over half of each cell only.
/// On record: the class of pbrt-v3 #319, a hole in the samples.
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

/// Weights each of two laws with the density of the other. The weights still sum to one, but the
/// variance is infinite.
/// On record: the class of three-gpu-pathtracer #847.
struct DensitiesSwapped {
  template <class Measure, class Real>
  static Real weight(const std::array<Real, 2>& n, const std::array<Density<Measure, Real>, 2>& p, std::size_t i) {
    return PowerHeuristic::weight(n, p, 1 - i);
  }
  static double excess(std::size_t laws) { return PowerHeuristic::excess(laws); }
};

/// Plays roulette with the largest reflectance, but divides by the mean of the three.
/// On record: the class of ospray #552.
struct RoulettePaidByMean {
  template <class Real, class Source>
  static Survival<Real> play(const Rgb<Real>& albedo, const Rgb<Real>&, const Real&, Source& source) {
    const auto survival = RussianRoulette::play<Real>(max_channel(albedo), source.next());
    return {survival.alive, Real(Real(3) / (albedo[0] + albedo[1] + albedo[2]))};
  }
};

/// Plays roulette with the throughput before the bounce, not after it, so a path goes on once more.
struct CarriedBefore {
  template <class Real, class Source>
  static Survival<Real> play(const Rgb<Real>&, const Rgb<Real>& throughput, const Real& depth, Source& source) {
    return RouletteByThroughput<>::play<Real>(Rgb<Real>::Ones(), throughput, depth, source);
  }
};

/// Divides by the survival probability at bounces without roulette too.
template <class Roulette>
struct SparedPaid : RouletteFromBounce<Roulette> {
  using RouletteFromBounce<Roulette>::RouletteFromBounce;

  template <class Real, class Source>
  Survival<Real> play(const Rgb<Real>& albedo, const Rgb<Real>& throughput, const Real& depth,
                      Source& source) const {
    const Mask<Real> alive = RouletteFromBounce<Roulette>::play(albedo, throughput, depth, source).alive;
    return {alive, Real(1) / max_channel(Rgb<Real>(throughput * albedo))};
  }
};

/// A probability above 1, clamped to 0.95: roulette never saves work.
/// On record: practical-path-guiding #3.
struct RouletteAtItsCap {
  template <class Real, class Source>
  static Survival<Real> play(const Rgb<Real>&, const Rgb<Real>&, const Real&, Source& source) {
    return RussianRoulette::play<Real>(rounded<Real>(0.95), source.next());
  }
};

/// Uses the number that chose a light again for the point on it, without rescaling.
/// On record: the class of pbrt-v4 795c619b.
struct OneOfReusingNumbers : UniformLightSampler {
  template <class Real, UniformSource<Real> Source, class Term>
  static auto sum(int n, Source& source, const Term& term) {
    Source same = source;
    const Pick<Real> pick = UniformChoice<Real>(n).sample(next_pair<Real>(source));
    return Real(term(pick.index, same) / pick.probability);
  }
};

/// Gives every term the same numbers. The mean is right, the variance is not.
/// On record: the class of zenphoton #8.
struct AllOfOneNumber : AllLights {
  template <class Real, UniformSource<Real> Source, class Term>
  static auto sum(int n, Source& source, const Term& term) {
    const Source first = source;
    auto total = zero<decltype(term(0, source))>();
    for (int i = 0; i < n; ++i) {
      source = first;
      total += term(i, source);
    }
    return total;
  }
};

/// Gives every run the same numbers, so that more runs add nothing.
/// On record: the class of SORT #35.
template <class Inner>
class SplittingOfOneRun : public Splitting<Inner> {
 public:
  SplittingOfOneRun(const Inner& inner, double k) : Splitting<Inner>(inner, k), inner_(inner) {}
  auto estimate(auto& source) const { return inner_.estimate(source); }

 private:
  Inner inner_;
};

/// Draws the control from other numbers, so the two are uncorrelated.
template <class Inner, class Control>
class ControlDrawnApart : public ControlVariate<Inner, Control> {
 public:
  ControlDrawnApart(const Inner& inner, const Control& control, double c, double mean)
      : ControlVariate<Inner, Control>(inner, control, c, mean),
        inner_(inner),
        control_(control),
        c_(c),
        mean_(mean) {}
  auto estimate(auto& source) const {
    using Real = typename Inner::Scalar;
    const Real difference = control_.estimate(source) - rounded<Real>(mean_);
    return Real(inner_.estimate(source) - difference * rounded<Real>(c_));
  }

 private:
  Inner inner_;
  Control control_;
  double c_, mean_;
};

/// Takes as many draws as the grid has cells, but not one in each.
template <class Inner>
class StrataForgotten : public StratifiedMean<Inner> {
 public:
  StrataForgotten(const Inner& inner, int columns, int rows)
      : StratifiedMean<Inner>(inner, columns, rows), inner_(inner), cells_(columns * rows) {}
  auto estimate(auto& source) const {
    using Real = typename Inner::Scalar;
    Real sum(0);
    for (int i = 0; i < cells_; ++i) sum += inner_.estimate(source);
    return Real(sum / rounded<Real>(cells_));
  }

 private:
  Inner inner_;
  int cells_;
};

/// A sum that drops what it rounds off.
/// On record: ice_halo_sim #380.
template <class Real>
struct PlainSum {
  Real sum = Real(0);
  void add(Real x) { sum += x; }
  Real value() const { return sum; }
};

}  // namespace fairlight::faults

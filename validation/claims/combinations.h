#pragma once

#include <fairlight/estimators/control_variate.h>
#include <fairlight/estimators/mis.h>
#include <fairlight/estimators/splitting.h>
#include <fairlight/estimators/stratification.h>
#include <fairlight/validation/checks/law_claims.h>
#include <fairlight/validation/claims/integrals.h>

namespace fairlight {

/// Combinators on integrals in closed form, and combinators of combinators. The bounds are those
/// that the estimators state.

/// Densities on the unit square that rise towards one side and vanish at the other: 4 x^3, or 4
/// (1 - x)^3.
template <class Real, bool mirrored>
struct PeakAtOneSide {
  using Scalar = Real;
  using Point = Vec2<Real>;
  using Measure = UnitCube;

  Point sample(const Vec2<Real>& u) const {
    using std::sqrt;
    const Real x = sqrt(sqrt(u.x()));
    return {mirrored ? Real(Real(1) - x) : x, u.y()};
  }
  Density<Measure, Real> pdf(const Point& point) const {
    const Real x = mirrored ? Real(Real(1) - point.x()) : point.x();
    return Density<Measure, Real>(Real(4) * x * x * x);
  }
};

/// Two peaks on a slope, f = 2 x^3 + (1 - x)^3 + y. Its integral over the unit square is
/// 2/4 + 1/4 + 1/2 = 5/4. By the law of one peak alone f / p is unbounded and has infinite
/// variance: the integral of f^2 / p diverges at the far side.
struct TwoPeaks {
  static constexpr double integral = 1.25;

  template <class Real>
  static auto integrand() {
    return [](const Vec2<Real>& point) {
      const Real x = point.x();
      const Real far = Real(1) - x;
      return Real(Real(2) * x * x * x + far * far * far + point.y());
    };
  }

  /// The laws of the two peaks, and the uniform one.
  template <class Real>
  static auto laws() {
    return std::tuple(PeakAtOneSide<Real, false>{}, PeakAtOneSide<Real, true>{}, UniformSquare<Real>{});
  }

  /// The bound of f over the mixture with shares c: since f <= p_1 / 2 + p_2 / 4 + p_3, it is the
  /// largest of 1/2 / c_1, 1/4 / c_2 and 1 / c_3.
  template <class Number>
  static Bound mixture(const std::array<Number, 3>& shares) {
    const std::array<double, 3> c{double(shares[0]), double(shares[1]), double(shares[2])};
    return {0, (c[0] + c[1] + c[2]) * std::max({0.5 / c[0], 0.25 / c[1], 1 / c[2]})};
  }
};

template <class Heuristic>
auto multi_sample_peaks(const std::string& name, const std::vector<std::string>& subjects) {
  const auto make = []<class Real>(std::type_identity<Real>) {
    constexpr std::array n{1, 2, 1};
    return MultiSampleMis(Heuristic{}, TwoPeaks::laws<Real>(), n, TwoPeaks::integrand<Real>(),
                          TwoPeaks::mixture(n));
  };
  return bounded_experiment(name, subjects,
                            "two peaks on a slope have the integral 5/4, from one, two and one draws of three laws",
                            "elementary; Veach 1997, 9.2", TwoPeaks::integral, make);
}

template <class Heuristic>
auto one_sample_of_peaks() {
  return []<class Real>(std::type_identity<Real>) {
    constexpr std::array c{0.3, 0.45, 0.25};
    return OneSampleMis(Heuristic{}, TwoPeaks::laws<Real>(), c, TwoPeaks::integrand<Real>(), TwoPeaks::mixture(c));
  };
}

template <class Heuristic>
auto one_sample_peaks(const std::string& name, const std::vector<std::string>& subjects) {
  return bounded_experiment(name, subjects,
                            "two peaks on a slope have the integral 5/4, from a draw of one of three laws",
                            "elementary; Veach 1997, 9.2.4", TwoPeaks::integral, one_sample_of_peaks<Heuristic>());
}

/// The solid angle of the hemisphere, by cosine-weighted and uniform directions. By cosine-weighted
/// ones alone 1 / p = pi / z is unbounded and has infinite variance.
template <class Heuristic>
auto solid_angle_by_two(const std::string& name) {
  constexpr double tau = 2 * std::numbers::pi;
  const std::array<double, 2> alone{infinity<double>, tau};
  const Bound mixture{0, mixture_bound({1, 1}, alone)};
  const auto make = [=]<class Real>(std::type_identity<Real>) {
    return MultiSampleMis(
        Heuristic{}, std::tuple(CosineHemisphere<Real>{}, UniformHemisphere<Real>{}), {1, 1},
        [](const Vec3<Real>&) { return Real(1); }, mixture);
  };
  return bounded_experiment(name, {"MultiSampleMis", "CosineHemisphere", "UniformHemisphere"},
                            "the hemisphere is 2 pi steradians, by cosine-weighted and uniform directions together",
                            "elementary", tau, make);
}

/// z^2 over the hemisphere by uniform directions: 2 pi / 3, with draws in [0, 2 pi).
inline auto height_squared() {
  return []<class Real>(std::type_identity<Real>) {
    return Importance(UniformHemisphere<Real>{}, [](const Vec3<Real>& w) { return cosine_power(w, 2); },
                      {0, 2 * std::numbers::pi});
  };
}
inline constexpr double height_squared_integral = 2 * std::numbers::pi / 3;

/// The same with z, whose integral is pi, as the control. The best factor is 1; this uses 3/4, so
/// that a wrong use of the factor shows.
template <template <class, class> class Variate>
auto controlled_height_squared() {
  return []<class Real>(std::type_identity<Real> real) {
    const auto inner = height_squared()(real);
    const Importance control(UniformHemisphere<Real>{}, [](const Vec3<Real>& w) { return w.z(); },
                             {0, 2 * std::numbers::pi});
    return Variate<std::remove_cv_t<decltype(inner)>, std::remove_cv_t<decltype(control)>>(inner, control, 0.75,
                                                                                           std::numbers::pi);
  };
}

template <template <class, class> class Variate>
auto control_variate_integral(const std::string& name) {
  return bounded_experiment(
      name, {"ControlVariate"}, "the integral of cos^2 over the hemisphere is 2 pi / 3, with cos for a control",
      "elementary; Hammersley and Handscomb 1964", height_squared_integral, controlled_height_squared<Variate>());
}

template <template <class> class Split>
auto splitting_integral(const std::string& name, double k) {
  const auto make = [=](auto real) {
    const auto inner = height_squared()(real);
    return Split<std::remove_cv_t<decltype(inner)>>(inner, k);
  };
  return bounded_experiment(
      name, {"Splitting"},
      "the integral of cos^2 over the hemisphere is 2 pi / 3, from " + std::to_string(k) + " runs in the mean",
      "elementary; Arvo and Kirk 1990", height_squared_integral, make);
}

template <template <class> class Strata>
auto stratified_integral(const std::string& name) {
  const auto make = [](auto real) {
    const auto inner = height_squared()(real);
    return Strata<std::remove_cv_t<decltype(inner)>>(inner, 3, 2);
  };
  return bounded_experiment(
      name, {"StratifiedMean"},
      "the integral of cos^2 over the hemisphere is 2 pi / 3, each draw a grid of 3 by 2 pairs",
      "elementary; Cook 1986", height_squared_integral, make);
}

/// Roulette of splitting of multiple importance sampling.
inline auto nested_peaks(const std::string& name) {
  const auto make = [](auto real) {
    return Rouletted(Splitting(one_sample_of_peaks<PowerHeuristic>()(real), 1.5), 0.9);
  };
  return bounded_experiment(name, {"Rouletted", "Splitting", "OneSampleMis"},
                            "roulette of splitting of multiple importance sampling keeps the mean", "elementary",
                            TwoPeaks::integral, make);
}

/// Takes the n numbers of an estimator in advance, so that the estimator after it has the same
/// numbers in each arithmetic.
template <class Inner>
struct WithNumbersOfItsOwn {
  using Scalar = typename Inner::Scalar;

  Inner inner;
  std::size_t numbers;

  struct Taken {
    std::vector<Scalar> numbers;
    std::size_t used = 0;
    Scalar next() { return numbers.at(used++); }
  };
  template <class Source>
  auto estimate(Source& source) const {
    Taken taken;
    while (taken.numbers.size() < numbers) taken.numbers.push_back(source.next());
    return inner.estimate(taken);
  }
  auto bound() const { return inner.bound(); }
};

/// Strata of roulette of a control variate.
inline auto nested_strata(const std::string& name) {
  const auto make = [](auto real) {
    return StratifiedMean(WithNumbersOfItsOwn(Rouletted(controlled_height_squared<ControlVariate>()(real), 0.8), 3),
                          2, 2);
  };
  return bounded_experiment(name, {"StratifiedMean", "Rouletted", "ControlVariate"},
                            "strata of roulette of a control variate keep the mean", "elementary",
                            height_squared_integral, make);
}

}  // namespace fairlight

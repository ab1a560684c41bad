#pragma once

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fairlight/estimators/control_variate.h>
#include <fairlight/estimators/splitting.h>
#include <fairlight/estimators/stratification.h>
#include <fairlight/validation/checks/parameters.h>
#include <fairlight/validation/claims/integrals.h>

namespace fairlight {

/// Integrands with drawn coefficients of both signs, by drawn laws, through every combinator and
/// over the whole domain of its parameters.

/// The integrand a + b x + c y + d x^2 + e x y^2 on the unit square.
struct SignedPolynomial {
  std::array<double, 5> a{};

  double integral() const { return a[0] + a[1] / 2 + a[2] / 2 + a[3] / 3 + a[4] / 6; }
  /// No value is larger.
  double largest() const {
    double sum = 0;
    for (const double coefficient : a) sum += std::abs(coefficient);
    return sum;
  }
  template <class Real>
  auto of() const {
    return [a = a](const Vec2<Real>& p) {
      const auto k = [&a](std::size_t i) { return rounded<Real>(a[i]); };
      const Real x = p.x(), y = p.y();
      return Real(k(0) + x * (k(1) + k(3) * x) + y * (k(2) + k(4) * x * y));
    };
  }
};

/// A density on the unit square that rises or falls along either axis: (1 + s (2x - 1)) (1 + t (2y -
/// 1)), |s| and |t| below 1.
template <class Real>
class TiltedSquare {
 public:
  using Scalar = Real;
  using Point = Vec2<Real>;
  using Measure = UnitCube;

  TiltedSquare(double s, double t) : slopes_{rounded<Real>(s), rounded<Real>(t)} {}

  Point sample(const Vec2<Real>& u) const { return {inverse(slopes_[0], u.x()), inverse(slopes_[1], u.y())}; }
  Density<Measure, Real> pdf(const Point& p) const {
    return Density<Measure, Real>(height(slopes_[0], p.x()) * height(slopes_[1], p.y()));
  }
  static double least(double s, double t) { return (1 - std::abs(s)) * (1 - std::abs(t)); }

 private:
  static Real height(Real s, Real x) { return Real(1) + s * (Real(2) * x - Real(1)); }
  // The root of s x^2 + (1 - s) x = u, without cancellation.
  static Real inverse(Real s, Real u) {
    using std::sqrt;
    const Real b = Real(1) - s;
    return Real(2) * u / (b + sqrt(Real(b * b + Real(4) * s * u)));
  }

  std::array<Real, 2> slopes_;
};

/// The parameters of n polynomials, one below zero, one of both signs and one above zero in turn, and
/// of a tilted law. That of both signs is steep along x and along y.
inline std::vector<ParameterRange> polynomial_ranges(const std::string& component, std::size_t n) {
  std::vector<ParameterRange> ranges;
  const auto add = [&](double low, double high) { ranges.push_back({component, "coefficient", low, high}); };
  for (std::size_t i = 0; i < n; ++i) {
    const double base = 1.5 * (static_cast<double>(i % 3) - 1);
    const bool steep = i % 3 == 1;
    const double most = steep ? 1 : 0.4;
    add(base - 0.5, base + 0.5);
    add(-most, steep ? -0.5 : most);
    add(steep ? 0.5 : -most, most);
    for (int k = 3; k < 5; ++k) add(-most, most);
  }
  for (int axis = 0; axis < 2; ++axis) ranges.push_back({component, "tilt of the law", -0.6, 0.6});
  return ranges;
}

/// n polynomials and their law.
template <std::size_t n>
struct TiltedPolynomials {
  std::array<SignedPolynomial, n> polynomials;
  double s, t;

  explicit TiltedPolynomials(DrawnValues& values) {
    for (SignedPolynomial& f : polynomials) {
      for (double& coefficient : f.a) coefficient = values.next();
    }
    s = values.next();
    t = values.next();
  }

  /// The importance sampling of polynomial i.
  template <class Real>
  auto importance(std::size_t i) const {
    const double most = polynomials[i].largest() / TiltedSquare<Real>::least(s, t);
    return Importance(TiltedSquare<Real>(s, t), polynomials[i].template of<Real>(), {-most, most});
  }
};

/// The estimand of n estimators at once, one for each channel: `make(type_identity<Real>)` gives them
/// as an array. Estimator i takes at most numbers[i] numbers. Its margin is relative to scales[i], as
/// its mean may be 0.
template <std::size_t n, class Make>
auto signed_experiments(const std::string& name, const std::vector<std::string>& subjects,
                        const std::string& source, const std::array<SignedPolynomial, n>& polynomials,
                        const std::array<double, n>& scales, const std::array<std::size_t, n>& numbers,
                        const Make& make) {
  const auto draw = [=]<class Real>(std::type_identity<Real> real, auto& source_of_numbers) {
    const auto estimators = make(real);
    Eigen::Array<Real, static_cast<int>(n), 1> drawn;
    for (std::size_t i = 0; i < n; ++i) {
      auto own = source_of_numbers.take(numbers[i]);
      drawn[static_cast<int>(i)] = estimators[i].estimate(own);
    }
    return drawn;
  };
  std::vector<Reference> references;
  const auto estimators = make(std::type_identity<double>{});
  for (std::size_t i = 0; i < n; ++i) {
    references.push_back(reference_of(polynomials[i].integral(), estimators[i].bound()));
    references.back().scale = scales[i];
  }
  return estimand(name, subjects, "polynomials with drawn coefficients of both signs have their exact integrals",
                  source, references, draw, 6);
}

/// n estimators combine(importance(i), i) as an array.
template <class Real, std::size_t n, class Combine>
auto combined(const TiltedPolynomials<n>& integrands, const Combine& combine) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return std::array{combine(integrands.template importance<Real>(i), i)...};
  }
  (std::make_index_sequence<n>());
}

/// Splitting into n drawn or fixed numbers of runs, from the n values after the integrand's.
template <template <class> class Split, std::size_t n>
auto split_polynomials(const std::string& name, const std::vector<double>& values) {
  DrawnValues next(values);
  const TiltedPolynomials<n> integrands(next);
  std::array<double, n> k{}, scales{};
  std::array<std::size_t, n> numbers{};
  for (std::size_t i = 0; i < n; ++i) {
    k[i] = next.next();
    scales[i] = std::max(1.0, 1 / std::sqrt(k[i]));
    numbers[i] = 1 + 2 * (1 + static_cast<std::size_t>(k[i]));
  }
  const auto make = [=]<class Real>(std::type_identity<Real>) {
    return combined<Real>(
        integrands, [&]<class Inner>(const Inner& inner, std::size_t i) { return Split<Inner>(inner, k[i]); });
  };
  return signed_experiments(name, {"Splitting", "Importance"}, "elementary; Arvo and Kirk 1990",
                            integrands.polynomials, scales, numbers, make);
}

/// Roulette with n probabilities.
template <class Roulette, std::size_t n>
auto rouletted_polynomials(const std::string& name, const std::vector<double>& values) {
  DrawnValues next(values);
  const TiltedPolynomials<n> integrands(next);
  std::array<double, n> q{}, scales{};
  std::array<std::size_t, n> numbers{};
  for (std::size_t i = 0; i < n; ++i) {
    q[i] = next.next();
    scales[i] = 1 / std::sqrt(q[i]);
    numbers[i] = 3;
  }
  const auto make = [=]<class Real>(std::type_identity<Real>) {
    return combined<Real>(integrands, [&]<class Inner>(const Inner& inner, std::size_t i) {
      return Rouletted<Inner, Roulette>(inner, q[i]);
    });
  };
  return signed_experiments(name, {"RussianRoulette", "Rouletted", "Importance"}, "elementary; Arvo and Kirk 1990",
                            integrands.polynomials, scales, numbers, make);
}

/// Strata of 1 by 1, 1 by 7, 16 by 3 and of a drawn grid.
template <template <class> class Strata>
auto stratified_polynomials(const std::string& name, const std::vector<double>& values) {
  DrawnValues next(values);
  const TiltedPolynomials<4> integrands(next);
  const int columns = static_cast<int>(next.next()), rows = static_cast<int>(next.next());
  const std::array<std::array<int, 2>, 4> grids{{{1, 1}, {1, 7}, {16, 3}, {columns, rows}}};
  std::array<std::size_t, 4> numbers{};
  for (std::size_t i = 0; i < 4; ++i) numbers[i] = 2 * static_cast<std::size_t>(grids[i][0] * grids[i][1]);
  const auto make = [=]<class Real>(std::type_identity<Real>) {
    return combined<Real>(integrands, [&]<class Inner>(const Inner& inner, std::size_t i) {
      return Strata<Inner>(inner, grids[i][0], grids[i][1]);
    });
  };
  return signed_experiments(name, {"StratifiedMean", "Importance"}, "elementary; Cook 1986", integrands.polynomials,
                            {1, 1, 1, 1}, numbers, make);
}

/// A control variate with another polynomial of the same law for its control, and three factors.
template <template <class, class> class Variate>
auto controlled_polynomials(const std::string& name, const std::vector<double>& values) {
  DrawnValues next(values);
  const TiltedPolynomials<6> all(next);  // three integrands and their controls
  const std::array factors{next.next(), next.next(), next.next()};
  const auto make = [=]<class Real>(std::type_identity<Real>) {
    const auto controlled = [&](std::size_t i) {
      const auto inner = all.template importance<Real>(i), control = all.template importance<Real>(i + 3);
      using Inner = std::remove_cv_t<decltype(inner)>;
      return Variate<Inner, Inner>(inner, control, factors[i], all.polynomials[i + 3].integral());
    };
    return std::array{controlled(0), controlled(1), controlled(2)};
  };
  const std::array integrands{all.polynomials[0], all.polynomials[1], all.polynomials[2]};
  return signed_experiments<3>(name, {"ControlVariate", "Importance"}, "elementary; Hammersley and Handscomb 1964",
                               integrands, {2, 2, 2}, {2, 2, 2}, make);
}

}  // namespace fairlight

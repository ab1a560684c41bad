#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <vector>

#include <fairlight/estimators/mis.h>
#include <fairlight/validation/claims/signed_polynomials.h>

namespace fairlight {

/// Multiple importance sampling of integrands of both signs.

/// Uniform on the left part of the square, x <= w. The density is 0 elsewhere.
template <class Real>
class LeftPart {
 public:
  using Scalar = Real;
  using Point = Vec2<Real>;
  using Measure = UnitCube;

  explicit LeftPart(double w) : width_(rounded<Real>(w)) {}

  Point sample(const Vec2<Real>& u) const { return {width_ * u.x(), u.y()}; }
  Density<Measure, Real> pdf(const Point& p) const {
    return Density<Measure, Real>(select(p.x() <= width_, Real(Real(1) / width_), Real(0)));
  }

 private:
  Real width_;
};

/// A colour of three polynomials, and four laws. The first is given twice, the third has no density
/// on a part of the square, and the last is rare where there is one draw.
struct PolynomialColour {
  TiltedPolynomials<3> integrands;
  double width;  ///< of the left part
  double rare;   ///< the probability of the last law, where there is one draw

  PolynomialColour(DrawnValues& values, bool one_draw)
      : integrands(values), width(values.next()), rare(one_draw ? values.next() : 0) {}

  static constexpr std::array counts{2, 2, 3, 1};
  std::array<double, 4> probabilities() const { return {0.3, 0.3, 0.4 - rare, rare}; }

  template <class Real>
  auto laws() const {
    const double s = integrands.s, t = integrands.t;
    return std::tuple(TiltedSquare<Real>(s, t), TiltedSquare<Real>(s, t), LeftPart<Real>(width),
                      TiltedSquare<Real>(-t, s));
  }
  template <class Real>
  auto integrand() const {
    const auto& f = integrands.polynomials;
    return [r = f[0].of<Real>(), g = f[1].of<Real>(), b = f[2].of<Real>()](const Vec2<Real>& p) {
      return Rgb<Real>(r(p), g(p), b(p));
    };
  }
  /// |f| over the density of the mixture, of which the first law has this share.
  Bound mixture(double share) const {
    double most = 0;
    for (const SignedPolynomial& f : integrands.polynomials) most = std::max(most, f.largest());
    most /= share * TiltedSquare<double>::least(integrands.s, integrands.t);
    return {-most, most};
  }
};

inline std::vector<ParameterRange> many_draws_ranges() {
  std::vector<ParameterRange> ranges = polynomial_ranges("MultiSampleMis", 3);
  ranges.push_back({"MultiSampleMis", "width of a law", 0.1, 0.9});
  return ranges;
}
inline std::vector<ParameterRange> one_draw_ranges() {
  std::vector<ParameterRange> ranges = polynomial_ranges("OneSampleMis", 3);
  ranges.push_back({"OneSampleMis", "width of a law", 0.1, 0.9});
  ranges.push_back({"OneSampleMis", "probability of a law", 1e-4, 0.01, ParameterRange::Law::logarithmic});
  return ranges;
}

namespace detail {

/// The estimand of a colour by one estimator, which `make(type_identity<Real>)` gives.
template <class Make>
auto colour_experiment(const std::string& name, const std::vector<std::string>& subjects,
                       const TiltedPolynomials<3>& integrands, const Make& make) {
  const Bound bound = make(std::type_identity<double>{}).bound();
  const auto references = for_channels([&](int c) {
    Reference reference = reference_of(integrands.polynomials[static_cast<std::size_t>(c)].integral(), bound);
    reference.scale = 1;
    return reference;
  });
  const auto draw = [make](auto real, auto& source) { return make(real).estimate(source); };
  return estimand(
      name, subjects,
      "three polynomials with drawn coefficients of both signs have their exact integrals, by a law that "
      "is given twice, one that misses a part and one that is rare",
      "elementary; Veach 1997, 9.2", references, draw, 6);
}

}  // namespace detail

template <class Heuristic>
auto polynomials_of_many_draws(const std::string& name, const std::vector<std::string>& subjects,
                               const std::vector<double>& values) {
  DrawnValues next(values);
  const PolynomialColour colour(next, false);
  return detail::colour_experiment(name, subjects, colour.integrands, [=]<class Real>(std::type_identity<Real>) {
    return MultiSampleMis(Heuristic{}, colour.laws<Real>(), PolynomialColour::counts, colour.integrand<Real>(),
                          colour.mixture(0.5));
  });
}

template <class Heuristic>
auto polynomials_of_one_draw(const std::string& name, const std::vector<std::string>& subjects,
                             const std::vector<double>& values) {
  DrawnValues next(values);
  const PolynomialColour colour(next, true);
  return detail::colour_experiment(name, subjects, colour.integrands, [=]<class Real>(std::type_identity<Real>) {
    return OneSampleMis(Heuristic{}, colour.laws<Real>(), colour.probabilities(), colour.integrand<Real>(),
                        colour.mixture(0.6));
  });
}

}  // namespace fairlight

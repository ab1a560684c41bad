#pragma once

#include <numbers>

#include <fairlight/estimators/density.h>
#include <fairlight/estimators/inversion.h>
#include <fairlight/estimators/ranges.h>

namespace fairlight {

/// Offsets from a pixel's centre, distributed as the Blackman-Harris window.
/// Formula  p(x, y) = b(x) b(y), b(x) = sum over k = 0 .. 3 of a_k cos(pi k x / r) / (2 a_0 r), a =
///          0.35875, 0.48829, 0.14128, 0.01168
/// Measure  area [1/pixel^2]
/// Domain   [-r,r]^2, else density 0; r in [1e-6, 1e6] pixels (else std::invalid_argument)
/// Random   u in [0,1)^2
/// Source   Harris 1978, "On the use of windows for harmonic analysis", 4-term, -92 dB
template <class Real>
class BlackmanHarrisFilter {
  // The window is smooth like a Gaussian, and nearly zero at a finite radius. Halley's method
  // inverts its CDF, to within a few units in the last place of 1 in u, in double and in floats.
 public:
  using Scalar = Real;
  using Point = Vec2<Real>;
  using Measure = Area;

  /// The radius r [pixel].
  explicit BlackmanHarrisFilter(Real radius) : radius_(radius) {
    using std::erf;
    using std::erfc;
    require_pixels(radius, "a Blackman-Harris filter's radius");
    start_kept_ = erf(Real(1) / start_scale());
    start_cut_ = erfc(Real(1) / start_scale());
  }

  Point sample(const Vec2<Real>& u) const { return {offset(u.x()), offset(u.y())}; }

  Density<Measure, Real> pdf(const Point& x) const {
    return Density<Measure, Real>(height(x.x()) * height(x.y()) / (Real(4) * radius_ * radius_));
  }

 private:
  // One half of the window at the distance z in [0,1] from its edge, in radii: the mass between the
  // edge and z, divided by the mass of the half, and its first two derivatives. As a polynomial in
  // h = sin^2(pi z / 2) all terms are positive, so no digits cancel.
  struct Half {
    Real mass, height, slope;

    explicit Half(Real z) {
      using std::cos;
      using std::sin;
      const Real half_turn = Real(0.5) * pi<Real> * z;
      const Real s = sin(half_turn);
      const Real c = cos(half_turn);
      const Real h = s * s;
      height = term(6e-5) + h * (term(0.05658) + h * (term(0.5696) + h * term(0.37376)));
      slope = pi<Real> * s * c * (term(0.05658) + h * (Real(2) * term(0.5696) + h * Real(3) * term(0.37376)));
      const Real cosine = Real(1) - Real(2) * h;  // of pi z, whose sine is 2 s c
      mass = z - Real(2) * s * c / pi<Real> *
                     (term(0.48829) - cosine * term(0.14128) +
                      (Real(4) * cosine * cosine - Real(1)) * term(0.01168 / 3));
    }

    static Real term(double a) { return rounded<Real>(a / 0.35875); }
  };

  // The start is the quantile of a Gaussian with a standard deviation of 0.245 radii, truncated at
  // the radius. From there three steps reach the rounding error of double for every u.
  static Real start_scale() { return rounded<Real>(0.245 * std::numbers::sqrt2); }

  Real offset(Real u) const {
    const Mask<Real> left = u < Real(0.5);
    const Real mass = Real(2) * select(left, u, Real(Real(1) - u));
    const Real start = Real(1) - start_scale() * detail::rough_inverse_erf(Real((Real(1) - mass) * start_kept_),
                                                                           Real(start_cut_ + mass * start_kept_));
    Real z = select(start > Real(0), start, Real(0));
    for (int step = 0; step < 3; ++step) {
      const Half half(z);
      z = detail::halley_step(z, Real(half.mass - mass), half.height, half.slope, Real(0), Real(1));
    }
    const Real size = radius_ * (Real(1) - z);
    return select(left, Real(-size), size);
  }

  Real height(Real x) const {
    using std::abs;
    const Real z = (radius_ - abs(x)) / radius_;
    return select(z >= Real(0), Half(z).height, Real(0));
  }

  Real radius_, start_kept_, start_cut_;
};

}  // namespace fairlight

#pragma once

#include <stdexcept>

#include <fairlight/estimators/density.h>
#include <fairlight/estimators/inversion.h>
#include <fairlight/estimators/ranges.h>

namespace fairlight {

/// Offsets from a pixel's centre, distributed as a Gaussian that is truncated at a radius along
/// each axis and renormalised. Its inverse CDF is accurate to the rounding of Real.
/// Formula  p(x, y) = g(x) g(y), g(x) = exp(-x^2 / (2 s^2)) / (s sqrt(2 pi) erf(r / (s sqrt 2)))
/// Measure  area [1/pixel^2]
/// Domain   |x|, |y| <= r; s, r in [1e-6, 1e6] pixels, r <= 5 s (else std::invalid_argument)
/// Random   u in [0,1)^2
/// Source   Ernst, Stamminger, Greiner 2006, "Filter importance sampling"; Giles 2012 (the inverse)
template <class Real>
class GaussianFilter {
 public:
  using Scalar = Real;
  using Point = Vec2<Real>;
  using Measure = Area;

  /// The standard deviation s of the Gaussian before truncation, and the radius r [pixel].
  GaussianFilter(Real deviation, Real radius) : radius_(radius) {
    using std::erf;
    using std::erfc;
    using std::sqrt;
    require_pixels(deviation, "a Gaussian filter's deviation");
    require_pixels(radius, "a Gaussian filter's radius");
    if (!all(radius <= Real(5) * deviation))
      throw std::invalid_argument(
          "a Gaussian filter's radius must be in (0, 5] deviations (beyond 5 is less than 6e-7 of it)");
    const Real scale = sqrt(Real(2)) * deviation;
    edge_ = radius / scale;
    kept_ = erf(edge_);
    cut_ = erfc(edge_);
    steepness_ = Real(1) / (scale * scale);
    const Real height = Real(1) / (scale * sqrt(Real(pi<Real>)) * kept_);
    peak_ = height * height;
  }

  Point sample(const Vec2<Real>& u) const { return {offset(u.x()), offset(u.y())}; }

  Density<Measure, Real> pdf(const Point& x) const {
    using std::abs;
    using std::exp;
    const Mask<Real> inside = abs(x.x()) <= radius_ && abs(x.y()) <= radius_;
    return Density<Measure, Real>(
        select(inside, Real(peak_ * exp(-steepness_ * (x.x() * x.x() + x.y() * x.y()))), Real(0)));
  }

 private:
  // The magnitude of the offset has the CDF erf(y) / erf(edge), y = x / (s sqrt 2). Near the edge,
  // where erf(y) loses digits, its complement is inverted.
  Real offset(Real u) const {
    const Mask<Real> left = u < Real(0.5);
    const Real beyond = Real(2) * select(left, u, Real(Real(1) - u));
    const Real y = inverse_erf(Real((Real(1) - beyond) * kept_), Real(cut_ + beyond * kept_));
    const Real size = radius_ * (y / edge_);
    return select(left, Real(-size), size);
  }

  // For Halley's step: value erf(y) - p, slope 2/sqrt(pi) exp(-y^2), curvature -2 y slope.
  Real inverse_erf(Real p, Real q) const {
    using std::erf;
    using std::erfc;
    using std::exp;
    using std::sqrt;
    const Real start = detail::rough_inverse_erf(p, q);
    const Real y = select(start < edge_, start, edge_);
    const Real value = select(p < Real(0.5), Real(erf(y) - p), Real(q - erfc(y)));
    const Real slope = Real(2) / sqrt(Real(pi<Real>)) * exp(-y * y);
    return detail::halley_step(y, value, slope, Real(Real(-2) * y * slope), Real(0), edge_);
  }

  Real radius_, edge_, kept_, cut_, steepness_, peak_;
};

}  // namespace fairlight

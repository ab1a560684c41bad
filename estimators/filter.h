#pragma once

#include <fairlight/estimators/density.h>
#include <fairlight/estimators/ranges.h>

namespace fairlight {

/// Uniform offsets from a pixel's centre, up to a radius along each axis. A radius of 0.5 pixels
/// covers exactly the pixel.
/// Formula  p(x, y) = 1 / (4 r^2)
/// Measure  area [1/pixel^2]
/// Domain   [-r,r]^2, r in [1e-6, 1e6] pixels (else std::invalid_argument); the density is 0
///          elsewhere
/// Random   u in [0,1)^2
/// Source   Ernst, Stamminger, Greiner 2006, "Filter importance sampling"
template <class Real>
class BoxFilter {
 public:
  using Scalar = Real;
  using Point = Vec2<Real>;
  using Measure = Area;

  /// The radius r [pixel].
  explicit BoxFilter(Real radius = Real(0.5)) : radius_(radius) { require_pixels(radius, "a box filter's radius"); }

  Point sample(const Vec2<Real>& u) const {
    return {radius_ * (Real(2) * u.x() - Real(1)), radius_ * (Real(2) * u.y() - Real(1))};
  }

  Density<Measure, Real> pdf(const Point& x) const {
    using std::abs;
    const Mask<Real> inside = abs(x.x()) <= radius_ && abs(x.y()) <= radius_;
    return Density<Measure, Real>(select(inside, Real(Real(1) / (Real(4) * radius_ * radius_)), Real(0)));
  }

 private:
  Real radius_;
};

/// Offsets from a pixel's centre, distributed as a tent that reaches the centres of the neighbours.
/// Each pixel samples its own filter, so pixels are independent.
/// Formula  p(x, y) = (1 - |x|) (1 - |y|)
/// Measure  area [1/pixel^2]
/// Domain   (-1,1)^2; the density is 0 elsewhere
/// Random   u in [0,1)^2; uses u + ulp/4, as u = 0 would map to the edge, where the density is 0
/// Source   Ernst, Stamminger, Greiner 2006, "Filter importance sampling"
template <class Real>
struct TentFilter {
  using Scalar = Real;
  using Point = Vec2<Real>;
  using Measure = Area;

  Point sample(const Vec2<Real>& u) const { return {offset(u.x()), offset(u.y())}; }

  Density<Measure, Real> pdf(const Point& x) const { return Density<Measure, Real>(height(x.x()) * height(x.y())); }

 private:
  static Real offset(Real u) {
    using std::sqrt;
    const Real step(ulp<Real> / 2);
    const Real left = sqrt(Real(2) * u + step) - Real(1);
    const Real right = Real(1) - sqrt(Real(2) * (Real(1) - u) - step);
    return select(u < Real(0.5), left, right);
  }

  static Real height(Real x) {
    using std::abs;
    const Real rise = Real(1) - abs(x);
    return select(rise > Real(0), rise, Real(0));
  }
};

}  // namespace fairlight

#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fairlight/validation/checks/parameters.h>

namespace fairlight {

/// One test for every sampler: integrands without symmetry, of both signs, over a law with drawn
/// parameters, in coordinates (a, b, d) of order one. a and b lie across the law's axis, d along it.
///
/// A law that has an axis, or the symmetry of a regular polygon, has E[a] = E[b] = E[a b] = E[a d]
/// = E[b d] = 0 and E[a^2] = E[b^2] = q. With E[d] = e, the integrands
///   a + a d + a^2,   b - a b + d,   d + a d - b d + a b
/// have the means q, e and e. The axes of a and b are turned by a drawn angle. A draw is h (1 +
/// t / p) / 2, of the density t in the claim's own words and the sampler's p. It has the same mean
/// for the right draws and the right p, and another one if either is wrong, or if both are.

/// The means q and e.
struct CoordinateMoments {
  double across, along;
};

/// The three integrands.
template <class Real>
Rgb<Real> skew_integrands(Real a, Real b, Real d) {
  return {a + a * d + a * a, b - a * b + d, d + a * d - b * d + a * b};
}

/// Their references. With |a|, |b| <= 1 and 0 <= d <= 1 (for lobes, times their factor, a d is at most
/// (3 / e)^1.5 = 1.2) they lie within -3 and 4. Bias is relative to 1, as means may be small.
inline std::vector<Reference> skew_references(const CoordinateMoments& moments) {
  const auto of = [](double mean) { return Reference{.mean = mean, .lower = -3, .upper = 4, .scale = 1}; };
  return {of(moments.across), of(moments.along), of(moments.along)};
}

/// The factor (1 + t / p) / 2; 1/2 for a draw whose density is 0, which is then a fault.
template <class Real>
Real half_density_ratio(Real target, Real density) {
  const Mask<Real> exists = density > Real(0);
  return (Real(1) + select(exists, Real(target / select(exists, density, Real(1))), Real(0))) / Real(2);
}

/// A law about an axis: density in proportion to cos^n(alpha), for 1 - cos(alpha) <= widest. With n
/// > 0, widest is 1. The integrands get the factor cos^(n/2), so that a sharp lobe's stay bounded.
/// Moments  h = 1 - cos; under the density (1 - h)^k, k = 3n/2, E[h] = 1 / (k + 2) and E[h^2] = 2 /
///          ((k + 2) (k + 3)); for n = 0, half and a third of `widest` and its square. sin^2 = 2h -
///          h^2
struct AxialLaw {
  Eigen::Vector3d axis{0, 0, 1};
  double exponent = 0, widest = 1;
  double turn = 0;  ///< the angle of the integrand's axes [rad]

  double depth() const { return widest / (exponent + 1); }
  double breadth() const {
    if (exponent == 0) return widest <= 1 ? std::sqrt(widest * (2 - widest)) : 1;
    return std::sqrt(std::min(1.0, 2 / (exponent + 1)));
  }
  CoordinateMoments moments() const {
    const double k = 1.5 * exponent;
    const double h = k == 0 ? widest / 2 : 1 / (k + 2);
    const double square = k == 0 ? widest * widest / 3 : 2 / ((k + 2) * (k + 3));
    const double factor = (exponent + 1) / (k + 1);
    return {factor * (2 * h - square) / 2 / (breadth() * breadth()), factor * h / depth()};
  }
  /// A unit vector across the axis, `turn` and an angle from a fixed one.
  Eigen::Vector3d across(double angle) const {
    const Eigen::Vector3d first = axis.unitOrthogonal();
    return std::cos(turn + angle) * first + std::sin(turn + angle) * axis.cross(first);
  }
  /// The density at the axis.
  double height() const { return (exponent + 1) / (2 * std::numbers::pi * widest); }
};

namespace detail {

/// The integrands of an axial law at w, with their factor, times the factor of the density.
template <class Real>
Rgb<Real> axial_draw(const AxialLaw& law, const Vec3<Real>& w, Real density) {
  using std::exp;
  using std::log1p;
  const Vec3<Real> off = w - rounded_vector<Real>(law.axis);
  const Real drop = off.squaredNorm() / Real(2);
  const Mask<Real> ahead = drop < Real(1);
  const Real lobe = exp(Real(rounded<Real>(law.exponent / 2) * log1p(-select(ahead, drop, Real(0)))));
  const Real root = law.exponent == 0 ? Real(1) : select(ahead, lobe, Real(0));
  const auto along = [&](double angle) {
    return Real(off.dot(rounded_vector<Real>(law.across(angle))) * rounded<Real>(1 / law.breadth()));
  };
  const Real ratio = half_density_ratio(Real(rounded<Real>(law.height()) * root * root), density);
  return skew_integrands(along(0), along(std::numbers::pi / 2), Real(drop * rounded<Real>(1 / law.depth()))) *
         Real(root * ratio);
}

}  // namespace detail

/// The estimand of a sampler of directions about an axis. `make(type_identity<Real>)` gives it.
template <class Make>
auto axial_integrands(const std::string& name, const std::string& subject, const AxialLaw& law, const Make& make) {
  const auto draw = [=]<class Real>(std::type_identity<Real> real, auto& source) {
    const auto sampler = make(real);
    const Vec3<Real> w = sampler.sample(next_pair<Real>(source));
    return detail::axial_draw<Real>(law, w, sampler.pdf(w).value());
  };
  return Estimand{name,
                  {subject},
                  "integrands without symmetry, of both signs, have their exact means over the sampler's draws and "
                  "under its density",
                  "elementary: moments about an axis",
                  4,
                  skew_references(law.moments()),
                  draw};
}

/// A law of offsets within a reach of the centre along each axis, or within a disk of that radius.
/// `spread` is the mean squared offset along an axis, divided by the reach's square.
struct OffsetLaw {
  double reach, spread;
  bool round = false;  ///< a disk or a polygon: offsets are at most `reach` long
  double turn = 0;     ///< the angle of the integrand's axes [rad]

  /// The longest offset.
  double longest() const { return round ? reach : reach * std::numbers::sqrt2; }
  CoordinateMoments moments() const {
    const double q = spread * reach * reach / (longest() * longest());
    return {q, 2 * q};
  }
};

/// The estimand of a sampler of offsets. `make(type_identity<Real>)` gives it, `target(x, y)` its
/// density, times reach^2, at an offset divided by the reach.
template <class Make, class Target>
auto offset_integrands(const std::string& name, const std::string& subject, const OffsetLaw& law, const Make& make,
                       const Target& target) {
  const auto draw = [=]<class Real>(std::type_identity<Real> real, auto& source) {
    const auto sampler = make(real);
    const Vec2<Real> offset = sampler.sample(next_pair<Real>(source));
    const Real reach = rounded<Real>(law.reach);
    const Real density = sampler.pdf(offset).value() * reach * reach;
    const Vec2<Real> x(offset.x() / reach, offset.y() / reach);
    const Real c = rounded<Real>(std::cos(law.turn) * law.reach / law.longest());
    const Real s = rounded<Real>(std::sin(law.turn) * law.reach / law.longest());
    const Real a = c * x.x() + s * x.y();
    const Real b = c * x.y() - s * x.x();
    return Rgb<Real>(skew_integrands(a, b, Real(a * a + b * b)) *
                     half_density_ratio(Real(target(x.x(), x.y())), density));
  };
  return Estimand{name,
                  {subject},
                  "integrands without symmetry, of both signs, have their exact means over the sampler's draws and "
                  "under its density",
                  "elementary: moments about the centre",
                  4,
                  skew_references(law.moments()),
                  draw};
}

}  // namespace fairlight

#pragma once

#include <stdexcept>
#include <utility>

#include <fairlight/estimators/gauss.h>
#include <fairlight/estimators/ggx.h>
#include <fairlight/estimators/ranges.h>

namespace fairlight {

namespace detail {

/// The slopes of the facets that reflect light from above the surface to `out`, as r (ax cos(phi),
/// ay sin(phi)), where D(m) cos(m) dm = r / (1 + r^2)^2 dr dphi / pi. For each azimuth phi the
/// integral over r runs from 0 to the slope at which the light comes from the horizon. Up to there
/// the integrand is smooth.
template <class Real, class Facets, class Reflectance>
class ReflectingSlopes {
 public:
  /// By symmetry, uses the equivalent direction with x, y >= 0, and names the axis of smaller
  /// roughness x.
  ReflectingSlopes(const Facets& facets, const Vec3<Real>& out, const Reflectance& reflectance)
      : ReflectingSlopes(facets.roughness(), out, magnitudes(out), reflectance) {}

  /// The integral of f z_in over `in`. The integrand changes fast with the azimuth in two places.
  /// One is the smoother axis: the longer the ellipse of slopes, the faster. The other is 90
  /// degrees from `out`, beyond which facets face away: the lower `out` is, the faster. So half a
  /// turn is split at these places, and the nodes are dense near them, on the scale of the fastest
  /// change. The other half of the turn has the opposite slopes.
  auto albedo() const {
    using std::atan2;
    using std::min;
    using std::sqrt;
    const Vec3<Real> stretched = facets_.stretched(out_);
    const Real crossing = stretched.x() + stretched.y();
    const Real azimuth = atan2(stretched.y(), select(crossing > Real(0), stretched.x(), Real(1)));
    const Real quarter = pi<Real> / Real(2);
    const Real first = azimuth - quarter;
    const Real last = azimuth + quarter;
    const Real at_axis = alpha_.x() / alpha_.y();
    const Real across_out = out_.z() / stretched.norm();
    const Real narrow = min(at_axis, Real(sqrt(first * first + across_out * across_out)));
    const Real low = min(across_out, Real(sqrt(first * first + at_axis * at_axis)));
    return Value((from(first, Real(-first / Real(2)), low) - from(Real(0), Real(first / Real(2)), narrow) +
                  from(Real(0), Real(last / Real(2)), narrow) - from(last, Real(-last / Real(2)), low)) /
                 Real(pi<Real>));
  }

 private:
  using Value = decltype(std::declval<Reflectance>()(Real(1)));

  static Vec2<Real> magnitudes(const Vec3<Real>& w) {
    using std::abs;
    return {abs(w.x()), abs(w.y())};
  }

  ReflectingSlopes(const Vec2<Real>& alpha, const Vec3<Real>& out, const Vec2<Real>& across,
                   const Reflectance& reflectance)
      : alpha_(smoother_first(alpha, alpha)),
        out_(smoother_first(alpha, across).x(), smoother_first(alpha, across).y(), out.z()),
        facets_(alpha_.x(), alpha_.y()),
        reflectance_(reflectance) {}

  static Vec2<Real> smoother_first(const Vec2<Real>& alpha, const Vec2<Real>& v) {
    return select(alpha.x() > alpha.y(), Vec2<Real>(v.y(), v.x()), v);
  }

  /// Integrates over the azimuths from `end` to end + width (width may be negative), and over the
  /// opposite azimuths. A sinh substitution makes the nodes dense within `fast` of the end.
  Value from(Real end, Real width, Real fast) const {
    using std::asinh;
    using std::cos;
    using std::cosh;
    using std::sin;
    using std::sinh;
    const Real reach = asinh(Real(width / fast));
    const auto both = [&](Real t) {
      const Real azimuth = end + fast * sinh(Real(reach * t));
      const Vec2<Real> slope(alpha_.x() * cos(azimuth), alpha_.y() * sin(azimuth));
      return Value((along(slope) + along(-slope)) * Real(cosh(Real(reach * t))));
    };
    return integrate_unit<Real, 16>(both) * Real(reach * fast);
  }

  /// Integrates over the multiples r of a slope, with a sinh substitution, up to the horizon: 2 (z
  /// + k r) = z (1 + r^2 slope^2).
  Value along(const Vec2<Real>& slope) const {
    using std::abs;
    using std::asinh;
    using std::sinh;
    using std::sqrt;
    const Real k = out_.x() * slope.x() + out_.y() * slope.y();
    const Real square = slope.squaredNorm();
    const Real sum = abs(k) + sqrt(k * k + out_.z() * out_.z() * square);
    const Real reach = asinh(select(k > Real(0), Real(sum / (out_.z() * square)), Real(out_.z() / sum)));
    const auto light = [&](Real t) {
      const Real r = sinh(Real(reach * t));
      const Real facing = out_.z() + k * r;                // out.m divided by m.z
      const Real length = sqrt(Real(1) + square * r * r);  // 1 / m.z
      const Real twice = Real(2) * facing / (length * length);
      const Vec3<Real> in(twice * r * slope.x() - out_.x(), twice * r * slope.y() - out_.y(), twice - out_.z());
      const Real cosh_square = Real(1) + r * r;
      const Real seen = Real(4) * facing * in.z() * facets_.visibility(out_, in);
      return Value(reflectance_(Real(facing / length)) * Real(seen * r / (cosh_square * sqrt(cosh_square))));
    };
    return integrate_unit<Real, 48>(light) * reach;
  }

  Vec2<Real> alpha_;
  Vec3<Real> out_;
  Facets facets_;
  const Reflectance& reflectance_;
};

}  // namespace detail

/// The albedo of GGX facets by single reflection towards `out`, z > 0: the integral of f z_in over
/// `in`. `reflectance` maps the cosine at the facet to a number or a colour. Accurate to 2e-6 for
/// any roughness in [1e-4, 1] and z >= 1e-6, and to 1e-8 if the roughness is isotropic and out.y =
/// 0; floats add about 1e-6. Evaluates 6144 nodes: too slow for every bounce. Throws
/// std::invalid_argument for z below 1e-6 in floats, below 1e-10 in double.
template <class Real, class Facets, class Reflectance>
auto ggx_albedo(const Facets& facets, const Vec3<Real>& out, const Reflectance& reflectance) {
  if (!all(out.z() >= rounded<Real>(in_floats<Real> ? 1e-6 : 1e-10))) {
    throw std::invalid_argument(
        "an albedo of facets is not known at grazing angles (give a direction with z of at least 1e-6 in floats, "
        "1e-10 in double)");
  }
  return detail::ReflectingSlopes<Real, Facets, Reflectance>(facets, out, reflectance).albedo();
}

}  // namespace fairlight

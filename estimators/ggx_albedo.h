#pragma once

#include <stdexcept>
#include <utility>

#include <fairlight/estimators/gauss.h>
#include <fairlight/estimators/ggx.h>
#include <fairlight/estimators/ranges.h>

namespace fairlight {

namespace detail {

/// The slopes of the facets that send light from above the surface on to `out`. They are r (ax cos(phi), ay sin(phi)),
/// where D(m) cos(m) dm = r / (1 + r^2)^2 dr dphi / pi. Light is taken along azimuths phi, from no slope to the one at
/// which it comes from the horizon: inside there the integrand is smooth.
template <class Real, class Facets, class Reflectance>
class ReflectingSlopes {
 public:
  /// Of four directions that are alike by symmetry it sees the one with x, y >= 0, and has the smoother axis as x.
  ReflectingSlopes(const Facets& facets, const Vec3<Real>& out, const Reflectance& reflectance)
      : ReflectingSlopes(facets.roughness(), out, magnitudes(out), reflectance) {}

  /// The integral of f z_in over `in`. It changes fast with the azimuth in two places: at the smoother axis, the more so the
  /// longer the ellipse of the slopes; and 90 degrees from `out`, beyond which facets turn away, the more so the lower it
  /// is. So half of the turn is cut there, and the nodes crowd there, within how near the fastest change is to the cut. The
  /// other half has the opposite slopes.
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

  /// The azimuths from `end` on by `width`, which may be negative, and those opposite. The nodes crowd within `fast` of the
  /// end, as sinh does.
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

  /// The multiples r of a slope, spread as sinh does, up to the horizon: 2 (z + k r) = z (1 + r^2 slope^2).
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
      const Real facing = out_.z() + k * r;                // out.m over m's height
      const Real length = sqrt(Real(1) + square * r * r);  // 1 over m's height
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

/// What GGX facets reflect once of the light that falls on them, towards `out` with z > 0: the integral of f z_in over
/// `in`, the reflectance being a function of the cosine at the facet, to a number or a colour. To 2e-6, for any
/// roughness in [1e-4, 1] and heights down to 1e-6; to 1e-8 for one roughness and out.y = 0; floats add some 1e-6. It
/// takes 6144 nodes: not for every bounce. Throws std::invalid_argument below 1e-6 in floats, 1e-10 in double.
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

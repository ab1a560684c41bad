#pragma once

#include <stdexcept>

#include <fairlight/estimators/density.h>
#include <fairlight/estimators/vec.h>

namespace fairlight {

/// The GGX microsurface: facets as on an ellipsoid, with Smith masking. All formulas use the length
/// s(w) = |(ax x, ay y, z)| of the stretched direction. Its squares only add, so nothing cancels in
/// floats, even at a roughness of 1e-4 or at grazing angles.
/// Source   Walter et al. 2007; Heitz 2014, "Understanding the masking-shadowing function"
template <class Real>
class Ggx {
 public:
  /// Roughness along x and y, each in [1e-4, 1]; throws std::invalid_argument otherwise.
  Ggx(Real alpha_x, Real alpha_y) : alpha_x_(alpha_x), alpha_y_(alpha_y) {
    for (const Real& alpha : {alpha_x, alpha_y}) {
      if (!all_within(alpha, 1e-4, 1))
        throw std::invalid_argument("a roughness must lie in [1e-4, 1] (smoother is a mirror)");
    }
  }

  Vec2<Real> roughness() const { return {alpha_x_, alpha_y_}; }

  /// (ax x, ay y, z): maps facets and directions of the unit sphere to this surface.
  Vec3<Real> stretched(const Vec3<Real>& w) const { return {alpha_x_ * w.x(), alpha_y_ * w.y(), w.z()}; }

  /// (x / ax, y / ay, z), the inverse of `stretched`.
  Vec3<Real> unstretched(const Vec3<Real>& m) const { return {m.x() / alpha_x_, m.y() / alpha_y_, m.z()}; }

  /// D(m) = 1 / (pi ax ay (x^2/ax^2 + y^2/ay^2 + z^2)^2): the area of facets by normal, per area of
  /// the surface [1/sr]; 0 for z < 0.
  Real distribution(const Vec3<Real>& m) const {
    const Real square = unstretched(m).squaredNorm();
    return select(m.z() >= Real(0), Real(Real(1) / (pi<Real> * alpha_x_ * alpha_y_ * (square * square))), Real(0));
  }

  /// The projected area of the facets that face w (z > 0), along w: the integral of max(0, w.m)
  /// D(m) dm = (z + s) / 2.
  Real projected_area(const Vec3<Real>& w) const { return (w.z() + stretched(w).norm()) / Real(2); }

  /// G1(w) = z / projected_area(w): the fraction of the projected area that other facets do not
  /// hide. Needs z >= 0.
  Real masking(const Vec3<Real>& w) const { return w.z() / projected_area(w); }

  /// G2 / (4 z_out z_in) = 1 / (2 (s_out z_in + s_in z_out)), for directions with z > 0. G2 is the
  /// fraction that is visible from both: G2 = 1 / (1 + Lambda_out + Lambda_in), with 1 + 2 Lambda =
  /// s / z. Masking is height-correlated.
  Real visibility(const Vec3<Real>& out, const Vec3<Real>& in) const {
    return Real(1) / (Real(2) * (stretched(out).norm() * in.z() + stretched(in).norm() * out.z()));
  }

 private:
  Real alpha_x_, alpha_y_;
};

/// The distribution of GGX facet normals that are visible from `out`.
/// Formula  p(m) = G1(out) max(0, out.m) D(m) / z_out = max(0, out.m) D(m) / projected_area(out)
/// Measure  solid angle [1/sr]
/// Domain   unit normals, z >= 0; out is a unit vector with z > 0 (else std::invalid_argument)
/// Random   u in [0,1)^2
/// Source   Heitz 2018, "Sampling the GGX distribution of visible normals"; Dupuy and Benyoub 2023,
///          "Sampling visible GGX normals with spherical caps"
template <class Real>
class GgxVisibleNormals {
 public:
  using Scalar = Real;
  using Point = Vec3<Real>;
  using Measure = SolidAngle;

  GgxVisibleNormals(const Ggx<Real>& facets, const Vec3<Real>& out)
      : facets_(facets), out_(out), area_(facets.projected_area(out)) {
    using std::sqrt;
    if (!all(out.z() > Real(0)))
      throw std::invalid_argument("normals are seen from below the surface (give a direction with z > 0)");
    require_unit(out, "the direction that normals are seen from");
    // Seen from the stretched direction w the facets are a hemisphere. A w within 1e-15 of the pole
    // counts as the pole.
    const Vec3<Real> w = facets.stretched(out) / facets.stretched(out).norm();
    const Real sine = sqrt(w.x() * w.x() + w.y() * w.y());
    const Mask<Real> tilted = sine > rounded<Real>(1e-15);
    sine_ = select(tilted, sine, Real(0));
    cosine_ = w.z();
    const Real divisor = select(tilted, sine, Real(1));
    azimuth_ = {select(tilted, Real(w.x() / divisor), Real(1)), select(tilted, Real(w.y() / divisor), Real(0))};
  }

  /// The half vector of w and c, unstretched; c is uniform on the cap c_z > -w_z. If c is near -w
  /// their sum cancels, so it is computed by components. Let c = -radius (cos a, sin a) in the
  /// azimuth of w; along that azimuth the sum is sine - radius cos a = (sine^2 - radius^2) / (sine
  /// + radius) + 2 radius sin^2(a/2), with sine^2 - radius^2 = c_z^2 - w_z^2.
  Point sample(const Vec2<Real>& u) const {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const Real lack = sine_ * sine_ / (Real(1) + cosine_);        // 1 - w_z
    const Real drop = u.x() * (Real(1) + cosine_);                // 1 - c_z
    const Real height = (Real(1) - u.x()) * (Real(1) + cosine_);  // w_z + c_z
    const Real radius = sqrt(drop * (lack + height));
    const Real half_turn = pi<Real> * (u.y() - Real(0.5));
    const Real sum = sine_ + radius;
    const Real apart = (lack - drop) * height / select(sum > Real(0), sum, Real(1));
    const Real along = apart + Real(2) * radius * (sin(half_turn) * sin(half_turn));
    const Real across = Real(-2) * radius * (sin(half_turn) * cos(half_turn));
    const Vec3<Real> m = facets_.stretched(
        {azimuth_.x() * along - azimuth_.y() * across, azimuth_.y() * along + azimuth_.x() * across, height});
    return m / m.norm();
  }

  /// The random numbers in [0,1]^2 that give a visible normal: the inverse of `sample`, up to
  /// rounding. At the top of the cap every u_y gives the same normal, and the result is one of
  /// them. A normal above the surface that faces away from `out` has no such numbers; its u_x is
  /// above 1.
  Vec2<Real> invert(const Point& m) const {
    using std::atan2;
    const Vec3<Real> n = facets_.unstretched(m) / facets_.unstretched(m).norm();
    const Vec3<Real> w(azimuth_.x() * sine_, azimuth_.y() * sine_, cosine_);
    const Vec3<Real> c = Real(2) * w.dot(n) * n - w;
    const Real along = azimuth_.x() * c.x() + azimuth_.y() * c.y();
    const Real across = azimuth_.x() * c.y() - azimuth_.y() * c.x();
    const Real forward = select(along * along + across * across > Real(0), Real(-along), Real(1));
    // 1 - c_z; near the top of the cap computed from the radius, which is accurate there.
    const Mask<Real> high = c.z() > Real(0);
    const Real rise = Real(1) + select(high, c.z(), Real(0));
    const Real drop = select(high, Real((along * along + across * across) / rise), Real(Real(1) - c.z()));
    return {drop / (Real(1) + cosine_), atan2(Real(-across), forward) / (Real(2) * pi<Real>)+Real(0.5)};
  }

  Density<Measure, Real> pdf(const Point& m) const {
    const Real facing = out_.dot(m);
    const Real seen = select(facing > Real(0), facing, Real(0));
    return Density<Measure, Real>(seen * facets_.distribution(m) / area_);
  }

  /// The density of the direction into which a visible normal reflects `out`: p(m) / (4 out.m).
  Density<Measure, Real> reflected_pdf(const Point& m) const {
    return Density<Measure, Real>(facets_.distribution(m) / (Real(4) * area_));
  }

 private:
  Ggx<Real> facets_;
  Vec3<Real> out_;
  Real area_;           ///< projected area of the facets, along out
  Real sine_, cosine_;  ///< of the stretched direction
  Vec2<Real> azimuth_;
};

}  // namespace fairlight

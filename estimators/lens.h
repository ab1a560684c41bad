#pragma once

#include <cmath>
#include <stdexcept>
#include <utility>

#include <fairlight/estimators/density.h>
#include <fairlight/estimators/ranges.h>

namespace fairlight {

namespace detail {

/// Apertures scale their points to 8 ulp inside the rim, so that rounding in sine and cosine moves
/// none across it.
template <class Real>
inline constexpr Lane<Real> inside_rim = 1 - 8 * ulp<Real>;

}  // namespace detail

/// Uniform points of a round aperture, by the concentric map: neighbours on the square are
/// neighbours on the disk.
/// Formula  p(x) = 1 / (pi R^2)
/// Measure  area [1/m^2]
/// Domain   the disk |x| <= R, the density is 0 elsewhere; R in [1e-18, 1e18] m in floats, in
///          [1e-150, 1e150] m in double (throws std::invalid_argument otherwise)
/// Random   u in [0,1)^2
/// Source   Shirley and Chiu 1997, "A low distortion map between disk and square"
template <class Real>
class CircularAperture {
 public:
  using Scalar = Real;
  using Point = Vec2<Real>;
  using Measure = Area;

  /// The radius R [m].
  explicit CircularAperture(Real radius) : radius_(radius) { require_aperture(radius); }

  Point sample(const Vec2<Real>& u) const {
    using std::abs;
    using std::cos;
    using std::sin;
    const Real a = Real(2) * u.x() - Real(1);
    const Real b = Real(2) * u.y() - Real(1);
    const Mask<Real> wide = abs(a) > abs(b);
    const Real major = select(wide, a, b);
    const Real minor = select(wide, b, a);
    const Real angle = Real(0.25) * pi<Real> * minor / select(major == Real(0), Real(1), major);
    const Real r = detail::inside_rim<Real> * radius_ * major;
    const Real along = r * cos(angle);
    const Real across = r * sin(angle);
    return {select(wide, along, across), select(wide, across, along)};
  }

  Density<Measure, Real> pdf(const Point& x) const {
    const Mask<Real> inside = x.x() * x.x() + x.y() * x.y() <= radius_ * radius_;
    return Density<Measure, Real>(select(inside, Real(Real(1) / (pi<Real> * radius_ * radius_)), Real(0)));
  }

 private:
  Real radius_;
};

/// Uniform points of an aperture with n straight blades: a regular polygon.
/// Formula  p(x) = 1 / (n/2 R^2 sin(2 pi / n))
/// Measure  area [1/m^2]
/// Domain   the polygon with corners at distance R, the density is 0 elsewhere; n >= 3; R as for
///          CircularAperture (throws std::invalid_argument otherwise)
/// Random   u in [0,1)^2
/// Source   Turk 1990, "Generating random points in triangles"; Pharr, Jakob, Humphreys, PBR 4ed,
///          5.4
template <class Real>
class PolygonalAperture {
  // u_x chooses one of n triangles about the centre. The rest of u_x gives the distance from the
  // centre, and u_y the place along the blade.
 public:
  using Scalar = Real;
  using Point = Vec2<Real>;
  using Measure = Area;

  /// The distance R of the corners [m], the number n of blades, and the angle from +x to the first
  /// corner [rad].
  PolygonalAperture(Real radius, int blades, Real rotation = Real(0)) : blades_(blades), rotation_(rotation) {
    using std::cos;
    using std::sin;
    require_aperture(radius);
    if (blades < 3) throw std::invalid_argument("an aperture needs three blades or more (or none, and is round)");
    if (!all_finite(rotation))
      throw std::invalid_argument("an aperture's rotation must be finite (it is an angle)");
    half_sector_ = pi<Real> / rounded<Real>(blades);
    apothem_ = radius * cos(half_sector_);
    half_side_ = radius * sin(half_sector_);
  }

  Point sample(const Vec2<Real>& u) const {
    using std::floor;
    using std::sqrt;
    const Real turn = u.x() * rounded<Real>(blades_);
    const Real blade = floor(turn);
    const Real distance = detail::inside_rim<Real> * sqrt(turn - blade);
    const Real out = apothem_ * distance;
    const Real along = half_side_ * distance * (Real(2) * u.y() - Real(1));
    const Point normal = normal_of(blade);
    return {out * normal.x() - along * normal.y(), out * normal.y() + along * normal.x()};
  }

  Density<Measure, Real> pdf(const Point& x) const {
    using std::atan2;
    using std::floor;
    const Mask<Real> centre = x.x() == Real(0) && x.y() == Real(0);  // has no angle; atan2 of a packet gives NaN
    const Real angle = atan2(x.y(), select(centre, Real(1), x.x()));
    const Real blade = floor((angle - rotation_) / (Real(2) * half_sector_));
    const Point normal = normal_of(blade);
    const Mask<Real> inside = x.x() * normal.x() + x.y() * normal.y() <= apothem_;
    return Density<Measure, Real>(
        select(inside, Real(Real(1) / (rounded<Real>(blades_) * apothem_ * half_side_)), Real(0)));
  }

 private:
  // The direction from the centre to the middle of a blade.
  Point normal_of(Real blade) const {
    using std::cos;
    using std::sin;
    const Real angle = rotation_ + (Real(2) * blade + Real(1)) * half_sector_;
    return {cos(angle), sin(angle)};
  }

  int blades_;
  Real rotation_, half_sector_, apothem_, half_side_;
};

/// A camera ray in the camera's frame: x to the right, y down, z along the axis. The direction has
/// z = 1, so it is not a unit vector: origin + d direction lies in the plane at distance d.
template <class Real>
struct LensRay {
  Vec3<Real> origin;     ///< on the lens, z = 0 [m]
  Vec3<Real> direction;  ///< z = 1
};

/// A thin lens. All its points see a point of the plane at the distance f where the pinhole sees
/// it. A point at the distance d appears shifted by l (1/f - 1/d) from the point l of the lens. So
/// it blurs to a disk of radius R |d - f| / (f d) on the image plane at distance 1.
/// Formula  origin l, direction w - l / f, for the pinhole's direction w with z = 1
/// Domain   f > 0 in m; infinity focuses the lens at infinity (else std::invalid_argument)
/// Random   u in [0,1)^2
/// Source   Cook, Porter, Carpenter 1984, "Distributed ray tracing"; the paper, 3.2.3
template <class Real, class Aperture>
class ThinLens {
 public:
  ThinLens(Real focus_distance, Aperture aperture) : focus_(focus_distance), aperture_(std::move(aperture)) {
    if (!all(focus_distance > Real(0)) || !all_finite(Real(Real(1) / focus_distance)))
      throw std::invalid_argument("a lens must be focused in front of the camera (its distance divides)");
  }

  /// The ray through the lens point of u. `direction` is that of the pinhole, with z = 1.
  LensRay<Real> ray(const Vec3<Real>& direction, const Vec2<Real>& u) const {
    const Vec2<Real> l = aperture_.sample(u);
    return {{l.x(), l.y(), Real(0)},
            {direction.x() - l.x() / focus_, direction.y() - l.y() / focus_, direction.z()}};
  }

 private:
  Real focus_;
  Aperture aperture_;
};

}  // namespace fairlight

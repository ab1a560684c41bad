#pragma once

#include <fairlight/estimators/sphere_from_point.h>
#include <fairlight/estimators/uniform_sphere_area.h>

namespace fairlight {

/// Directions to points anywhere on a sphere; those on a face that is turned away do not exist. The points are drawn about
/// the axis towards the point that is lit, so that near points lose no digits.
/// Formula  p(w) = t^2 / (4 pi r^2 cos_L), t the distance to the nearest point in the direction w, cos_L the cosine there
/// Measure  solid angle [1/sr]
/// Domain   directions that meet the sphere; from its surface those that lead inwards; the density is 0 elsewhere
/// Random   u in [0,1)^2
/// Source   Shirley, Wang, Zimmerman 1996, 3.1; the paper, 3.2
template <class Real, template <class> class Points = UniformSphereArea>
class SphereByArea {
 public:
  using Scalar = Real;

  explicit SphereByArea(const SphereLight<Real>& sphere) : sphere_(sphere), points_(sphere.radius()) {}

  LightSample<Real> sample(const Vec3<Real>& from, const Vec2<Real>& u) const {
    const Vec3<Real> normal = points_.sample(u);
    return sphere_.seen_from(from).towards(normal, points_.pdf(normal));
  }

  Density<SolidAngle, Real> pdf(const Vec3<Real>& from, const Vec3<Real>& direction) const {
    return sphere_.seen_from(from).over_angle(direction, points_.pdf(direction));
  }

 private:
  SphereLight<Real> sphere_;
  Points<Real> points_;
};

/// Directions to points on the half of a sphere that faces the point that is lit. Only its cap with n_z > r/d is seen from
/// outside; the rest does not exist. Inside and at the surface the whole sphere is seen, and its points are drawn from all of it.
/// Formula  p(w) = t^2 / (2 pi r^2 cos_L) outside, t^2 / (4 pi r^2 cos_L) inside, with t and cos_L as for SphereByArea
/// Measure  solid angle [1/sr]
/// Domain   directions that meet the sphere; from its surface those that lead inwards; the density is 0 elsewhere
/// Random   u in [0,1)^2
/// Source   Shirley, Wang, Zimmerman 1996, 3.1
template <class Real, template <class> class Points = UniformSphereArea>
class SphereByVisibleHemisphere {
 public:
  using Scalar = Real;

  explicit SphereByVisibleHemisphere(const SphereLight<Real>& sphere) : sphere_(sphere), points_(sphere.radius()) {}

  LightSample<Real> sample(const Vec3<Real>& from, const Vec2<Real>& u) const {
    const SphereFromPoint<Real> view = sphere_.seen_from(from);
    const Real part = drawn_part(view);
    const Vec3<Real> normal = points_.sample({part * u.x(), u.y()});
    return view.towards(normal, Density<Area, Real>(points_.pdf(normal).value() / part));
  }

  Density<SolidAngle, Real> pdf(const Vec3<Real>& from, const Vec3<Real>& direction) const {
    const SphereFromPoint<Real> view = sphere_.seen_from(from);
    return view.over_angle(direction, Density<Area, Real>(points_.pdf(direction).value() / drawn_part(view)));
  }

 private:
  static Real drawn_part(const SphereFromPoint<Real>& view) { return select(view.outside(), Real(0.5), Real(1)); }

  SphereLight<Real> sphere_;
  Points<Real> points_;
};

/// Directions uniform in the cone that a sphere fills; from inside, and only there, that is every direction, and from the
/// surface the half of them that leads inwards. All of them exist. Nothing cancels, however small the cone: with sin(a) = r/d,
/// 1 - cos(a) = sin^2(a) / (1 + cos(a)).
/// Formula  p(w) = 1 / (2 pi (1 - cos(a)));  1 / (2 pi) at the surface, 1 / (4 pi) inside
/// Measure  solid angle [1/sr]
/// Domain   directions in the cone, to rounding; the density is 0 elsewhere
/// Random   u in [0,1)^2
/// Source   Shirley, Wang, Zimmerman 1996, 3.2; the cancellation: pbrt-v3 #212
template <class Real>
class SphereByCone {
 public:
  using Scalar = Real;

  explicit SphereByCone(const SphereLight<Real>& sphere) : sphere_(sphere) {}

  LightSample<Real> sample(const Vec3<Real>& from, const Vec2<Real>& u) const {
    return sphere_.seen_from(from).within_cone(u);
  }

  Density<SolidAngle, Real> pdf(const Vec3<Real>& from, const Vec3<Real>& direction) const {
    return sphere_.seen_from(from).cone_density(direction);
  }

 private:
  SphereLight<Real> sphere_;
};

}  // namespace fairlight

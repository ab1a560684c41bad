#pragma once

#include <fairlight/estimators/sphere_from_point.h>
#include <fairlight/estimators/uniform_sphere_area.h>

namespace fairlight {

/// Directions to uniform points of a whole sphere; points on its far side do not exist as samples.
/// Formula  p(w) = t^2 / (4 pi r^2 cos_L), t the distance to the nearest point in direction w,
///          cos_L the cosine there
/// Measure  solid angle [1/sr]
/// Domain   directions that hit the sphere (from its surface: that lead inwards); else density 0
/// Random   u in [0,1)^2
/// Source   Shirley, Wang, Zimmerman 1996, 3.1; the paper, 3.2
template <class Real, template <class> class Points = UniformSphereArea>
class SphereByArea {
  // The points are drawn about the axis to the lit point, so near points lose no digits.
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

/// Directions to uniform points of the hemisphere of a sphere that faces the lit point.
/// Formula  p(w) = t^2 / (2 pi r^2 cos_L) outside, t^2 / (4 pi r^2 cos_L) inside; t and cos_L as
///          for SphereByArea
/// Measure  solid angle [1/sr]
/// Domain   directions that hit the sphere (from its surface: that lead inwards); the density is 0
///          elsewhere
/// Random   u in [0,1)^2
/// Source   Shirley, Wang, Zimmerman 1996, 3.1
template <class Real, template <class> class Points = UniformSphereArea>
class SphereByVisibleHemisphere {
  // From outside, only the cap with n_z > r/d is visible; the other samples do not exist. Inside
  // and on the surface the whole sphere is visible, and the points are uniform on all of it.
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

/// Directions uniform in the cone that a sphere fills: inside all directions, on the surface the
/// half that leads inwards.
/// Formula  p(w) = 1 / (2 pi (1 - cos(a))); 1 / (2 pi) on the surface, 1 / (4 pi) inside
/// Measure  solid angle [1/sr]
/// Domain   directions in the cone, to rounding; the density is 0 elsewhere
/// Random   u in [0,1)^2
/// Source   Shirley, Wang, Zimmerman 1996, 3.2; the cancellation: pbrt-v3 #212
template <class Real>
class SphereByCone {
  // All samples exist. Nothing cancels, however small the cone: with sin(a) = r/d, 1 - cos(a) =
  // sin^2(a) / (1 + cos(a)).
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

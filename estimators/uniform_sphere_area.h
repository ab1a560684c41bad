#pragma once

#include <fairlight/estimators/ranges.h>
#include <fairlight/estimators/sphere_directions.h>

namespace fairlight {

/// Uniform points on a whole sphere. Those on the far side have a negative cosine, and count as 0.
/// Formula  p(x) = 1 / (4 pi r^2)
/// Measure  area [1/m^2]
/// Domain   points of the sphere, as unit outward normals n; the point is centre + r n
/// Random   u in [0,1)^2
/// Source   Archimedes (equal areas at equal heights); Shirley, Wang, Zimmerman 1996
template <class Real>
class UniformSphereArea {
 public:
  using Scalar = Real;
  using Point = Vec3<Real>;
  using Measure = Area;

  /// The radius [m], within the range of `longest`; throws std::invalid_argument otherwise.
  explicit UniformSphereArea(Real radius) : radius_(radius) { require_length(radius, "a sphere's radius"); }

  /// The outward unit normal at the point.
  Point sample(const Vec2<Real>& u) const { return normals_.sample(u); }

  Vec2<Real> invert(const Point& normal) const { return normals_.invert(normal); }

  /// From the centre, every point is at distance r with cosine 1.
  Density<Measure, Real> pdf(const Point& normal) const { return to_area(normals_.pdf(normal), radius_, Real(1)); }

 private:
  UniformSphere<Real> normals_;
  Real radius_;
};

}  // namespace fairlight

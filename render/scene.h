#pragma once

#include <string>
#include <vector>

#include <fairlight/estimators/sphere_light.h>
#include <fairlight/render/sphere.h>

namespace fairlight {

/// A surface's sphere and what it does with light.
struct Surface {
  Sphere<double> shape;
  Rgb<double> albedo;    ///< diffuse reflectance, in [0,1] per channel
  Rgb<double> radiance;  ///< emitted, the same in all directions and from both sides [W/(sr m^2)]
};

/// A surface that emits, as a sphere to be sampled.
struct Luminaire {
  int surface;           ///< its index in the scene
  Vec3<double> centre;   ///< [m]
  double radius;         ///< [m]
  Rgb<double> radiance;  ///< [W/(sr m^2)]
};

/// A half line; `leaving` is the surface that it starts on, or -1. The direction is a unit vector.
template <class Real>
struct Ray {
  Vec3<Real> origin;
  Vec3<Real> direction;
  int leaving;
};

/// Where a ray first meets a surface; surface is -1 and the distance infinite where it meets none.
template <class Real>
struct Hit {
  Real distance;
  int surface;
};

/// Spheres, some of which emit. Every sphere is closed or as good as flat; there is no other geometry yet.
class Scene {
 public:
  /// A sphere by centre and radius [m]. Throws std::invalid_argument for a radius that is not positive and finite,
  /// an albedo outside [0,1], or a radiance that is negative or not finite.
  void add_sphere(const Vec3<double>& centre, double radius, const Rgb<double>& albedo,
                  const Rgb<double>& radiance);

  /// A wall: the sphere of the given radius [m] that passes through `point` with the outward unit normal `outward`
  /// there. Exact for any radius. Throws as add_sphere, and when the normal is not a unit vector to 1e-9.
  void add_wall(const Vec3<double>& point, const Vec3<double>& outward, double radius, const Rgb<double>& albedo,
                const Rgb<double>& radiance);

  const std::vector<Surface>& surfaces() const { return surfaces_; }
  const std::vector<Luminaire>& luminaires() const { return luminaires_; }

  /// The first surface that the ray meets.
  template <class Real>
  Hit<Real> intersect(const Ray<Real>& ray) const {
    Hit<Real> hit{infinity<Real>, -1};
    for (int i = 0; i < static_cast<int>(surfaces_.size()); ++i) {
      const Real distance = shape(i).distance(ray.origin, ray.direction, ray.leaving == i);
      if (distance < hit.distance) hit = {distance, i};
    }
    return hit;
  }

  /// Whether nothing but the surface `target` stands on the ray closer than `distance` [m]. The target is convex
  /// and its point faces the origin, so it does not stand in its own way.
  template <class Real>
  bool visible(const Ray<Real>& ray, Real distance, int target) const {
    for (int i = 0; i < static_cast<int>(surfaces_.size()); ++i) {
      if (i != target && shape(i).distance(ray.origin, ray.direction, ray.leaving == i) < distance) return false;
    }
    return true;
  }

 private:
  void add(const Sphere<double>& shape, double radius, const Rgb<double>& albedo, const Rgb<double>& radiance);
  const Sphere<double>& shape(int surface) const { return surfaces_[static_cast<std::size_t>(surface)].shape; }

  std::vector<Surface> surfaces_;
  std::vector<Luminaire> luminaires_;
};

}  // namespace fairlight

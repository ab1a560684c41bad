#pragma once

#include <fairlight/estimators/concepts.h>
#include <fairlight/estimators/pick_one.h>
#include <fairlight/estimators/sphere_light.h>
#include <fairlight/render/scene.h>

namespace fairlight {

/// `Geometry` below is a Scene, or anything that answers as one does.

/// A point on a surface that light is reflected at: `normal` is the unit normal on the side where it is reflected.
template <class Real>
struct Vertex {
  Vec3<Real> position;
  Vec3<Real> normal;
  int surface;
};

/// Radiance reflected at a vertex that comes straight from the luminaires, by a shadow ray to a point of each of them or
/// of one of them.
/// Formula  sum over L of  f Le cos / p_w,  p_w = p_A d^2 / cos_L, where the point faces the vertex and is seen; else 0
/// Measure  the points by area, turned into solid angle
/// Domain   spheres that emit, from without, from within, or from their own surface
/// Random   two dimensions per shadow ray, and one for the choice
/// Bound    per luminaire, A max(Le f) / d^2 with d the smallest distance from the vertex to the luminaire
/// Source   Shirley, Wang, Zimmerman 1996; the paper, 3.2 and A.1
template <class Luminaires, template <class> class PointsOnSphere = UniformSphereArea>
struct DirectLight {
  /// Emission is counted where the path starts; later it has been counted by a shadow ray (the paper, A.2).
  static constexpr bool counts_emission(int depth) { return depth == 0; }

  template <class Real, class Geometry, UniformSource<Real> Source, class Bsdf>
  static Rgb<Real> estimate(const Geometry& scene, const Vertex<Real>& vertex, const Bsdf& bsdf, Source& source) {
    const auto& luminaires = scene.luminaires();
    if (luminaires.empty()) return Rgb<Real>::Zero();
    const auto term = [&](int i, Source& numbers) {
      return from(luminaires[static_cast<std::size_t>(i)], scene, vertex, bsdf, numbers);
    };
    return Luminaires::template sum<Real>(static_cast<int>(luminaires.size()), source, term);
  }

 private:
  template <class Real, class Geometry, class Source, class Bsdf>
  static Rgb<Real> from(const Luminaire& light, const Geometry& scene, const Vertex<Real>& vertex, const Bsdf& bsdf,
                        Source& source) {
    const PointsOnSphere<Real> points(light.radius);
    const Vec3<Real> outward = points.sample(next_pair<Real>(source));
    const Vec3<Real> to_light = light.centre + light.radius * outward - vertex.position;
    const Real distance = to_light.norm();
    const Vec3<Real> direction = to_light / distance;
    const Real cosine_there = -side(light, scene, vertex) * outward.dot(direction);
    const Rgb<Real> reflected = bsdf.eval_world(direction);
    if (!(cosine_there > Real(0) && (reflected > Real(0)).any())) return Rgb<Real>::Zero();
    if (!scene.visible({vertex.position, direction, vertex.surface}, distance, light.surface))
      return Rgb<Real>::Zero();
    const Real cosine_here = vertex.normal.dot(direction);
    return light.radiance * reflected * cosine_here / to_solid_angle(points.pdf(outward), distance, cosine_there);
  }

  // +1 outside the luminaire, where its outward face is seen, -1 inside. On it, the side that reflects decides.
  template <class Real, class Geometry>
  static Real side(const Luminaire& light, const Geometry& scene, const Vertex<Real>& vertex) {
    const Sphere<double>& shape = scene.surfaces()[static_cast<std::size_t>(light.surface)].shape;
    const Real height = vertex.surface == light.surface ? shape.normal_at(vertex.position).dot(vertex.normal)
                                                        : shape.level(vertex.position);
    return select(height > Real(0), Real(1), Real(-1));
  }
};

/// No shadow rays: light is found by the bounces alone, and emission is counted at every depth.
/// Source   Kajiya 1986
struct NoDirectLight {
  static constexpr bool counts_emission(int) { return true; }

  template <class Real, class Geometry, UniformSource<Real> Source, class Bsdf>
  static Rgb<Real> estimate(const Geometry&, const Vertex<Real>&, const Bsdf&, Source&) {
    return Rgb<Real>::Zero();
  }
};

}  // namespace fairlight

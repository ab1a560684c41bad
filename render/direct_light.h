#pragma once

#include <utility>
#include <vector>

#include <fairlight/estimators/choose_light.h>
#include <fairlight/estimators/sphere_sampling.h>
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
/// of one of them: `Luminaires` says which (AllOf, OneOf, OneBy), `SphereSampling` where on it.
/// Formula  sum over L of  f Le cos / p_w, where the point is seen; else 0
/// Measure  solid angle, by SphereSampling
/// Domain   spheres that emit, from without, from within, or from their own surface; 0 where none does
/// Random   two dimensions per shadow ray, and those of the choice
/// Bound    per luminaire, max(Le f cos / p_w): by area at most A max(Le f) / d^2 with d the smallest distance from the
///          vertex to the luminaire, by cone S max(Le f) with S the cone's solid angle
/// Source   Shirley, Wang, Zimmerman 1996; the paper, 3.2 and A.1
template <class Luminaires, template <class> class SphereSampling = SphereByArea>
class DirectLight {
 public:
  explicit DirectLight(Luminaires luminaires = Luminaires()) : luminaires_(std::move(luminaires)) {}

  /// Emission is counted where the path starts; later it has been counted by a shadow ray (the paper, A.2).
  static constexpr bool counts_emission(int depth) { return depth == 0; }

  template <class Real, class Geometry, UniformSource<Real> Source, class Bsdf>
  Rgb<Real> estimate(const Geometry& scene, const Vertex<Real>& vertex, const Bsdf& bsdf, Source& source) const {
    const auto& luminaires = scene.luminaires();
    const auto term = [&](int i, Source& numbers) {
      return from(luminaires[static_cast<std::size_t>(i)], scene, vertex, bsdf, numbers);
    };
    return luminaires_.template sum<Real>(static_cast<int>(luminaires.size()), source, term);
  }

 private:
  // A luminaire on which the vertex itself lies shows its inner face to it: where it reflects outwards, nothing.
  template <class Real, class Geometry, class Source, class Bsdf>
  static Rgb<Real> from(const Luminaire& light, const Geometry& scene, const Vertex<Real>& vertex, const Bsdf& bsdf,
                        Source& source) {
    const SphereLight<Real> sphere(light.centre, light.radius, vertex.surface == light.surface);
    const auto [direction, distance, density] =
        SphereSampling<Real>(sphere).sample(vertex.position, next_pair<Real>(source));
    const Rgb<Real> reflected = bsdf.eval_world(direction);
    if (!(density.value() > Real(0) && (reflected > Real(0)).any())) return Rgb<Real>::Zero();
    if (!scene.visible({vertex.position, direction, vertex.surface}, distance, light.surface))
      return Rgb<Real>::Zero();
    const Real cosine = vertex.normal.dot(direction);
    return light.radiance * reflected * cosine / density;
  }

  Luminaires luminaires_;
};

/// One of a scene's luminaires by its power, 4 pi^2 r^2 times the mean of the radiance's channels [W], from each face.
inline OneBy<PowerChoice<double>> one_by_power(const Scene& scene) {
  std::vector<double> powers;
  for (const Luminaire& light : scene.luminaires()) {
    powers.push_back(4 * pi<double> * pi<double> * light.radius * light.radius * light.radiance.mean());
  }
  return OneBy(PowerChoice<double>(powers));
}

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

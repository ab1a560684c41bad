#pragma once

#include <stdexcept>
#include <utility>

#include <fairlight/estimators/lambertian.h>
#include <fairlight/estimators/roulette.h>
#include <fairlight/render/direct_light.h>

namespace fairlight {

/// A Lambertian surface at a vertex, in world directions.
template <class Real, template <class> class Directions>
class SurfaceBsdf {
 public:
  /// `out`: towards the viewer, in the world.
  SurfaceBsdf(const Rgb<Real>& albedo, const Vec3<Real>& normal, const Vec3<Real>& out)
      : material_(albedo), frame_(normal), out_(frame_.to_local(out)) {}

  /// The BRDF [1/sr], without the cosine; 0 below the surface.
  Rgb<Real> eval_world(const Vec3<Real>& direction) const {
    return material_.eval(out_, frame_.to_local(direction));
  }

  /// A bounce whose direction is in the world.
  Bounce<Real> sample_world(const Vec2<Real>& u) const {
    Bounce<Real> bounce = material_.sample(out_, u);
    bounce.in = frame_.to_world(bounce.in);
    return bounce;
  }

 private:
  Lambertian<Real, Directions> material_;
  Frame<Real> frame_;
  Vec3<Real> out_;
};

/// Radiance along a ray by following one path: emission, light from the luminaires, and what is reflected, each
/// strategy a component of its own. Unbiased with roulette or where every path ends; with a maximum depth it is
/// the sum of the terms up to that depth, and unbiased for that.
/// Formula  L = sum over depths of throughput x (emission + direct light)
/// Measure  none: an estimate of radiance [W/(sr m^2)]
/// Domain   diffuse spheres; a surface that is perfectly white in some channel and encloses the path needs a depth
/// Random   two dimensions per bounce, one per roulette, and those of the direct light
/// Source   Kajiya 1986; the paper, sections 2 and 3
template <template <class> class Directions, class Direct, class Roulette>
class PathTracer {
 public:
  static constexpr int no_limit = -1;

  /// max_depth: the number of bounces after which a path ends, or no_limit. Throws std::invalid_argument below
  /// that.
  explicit PathTracer(int max_depth = no_limit, Direct direct = Direct())
      : max_depth_(max_depth), direct_(std::move(direct)) {
    if (max_depth < no_limit) throw std::invalid_argument("a maximum depth must be nonnegative");
  }

  template <class Real, class Geometry, UniformSource<Real> Source>
  Rgb<Real> radiance(const Geometry& scene, Ray<Real> ray, Source& source) const {
    Rgb<Real> sum = Rgb<Real>::Zero();
    Rgb<Real> throughput = Rgb<Real>::Ones();
    for (int depth = 0;; ++depth) {
      const Hit<Real> hit = scene.intersect(ray);
      if (hit.surface < 0) return sum;
      const Surface& surface = scene.surfaces()[static_cast<std::size_t>(hit.surface)];
      if (Direct::counts_emission(depth)) sum += throughput * surface.radiance;
      if (depth == max_depth_) return sum;

      const Vertex<Real> vertex = vertex_at(surface.shape, hit, ray);
      const SurfaceBsdf<Real, Directions> bsdf(surface.albedo, vertex.normal, -ray.direction);
      sum += throughput * direct_.template estimate<Real>(scene, vertex, bsdf, source);

      if (depth + 1 == max_depth_ && !Direct::counts_emission(max_depth_)) return sum;

      const auto [alive, weight] = Roulette::template play<Real>(surface.albedo, throughput, depth, source);
      if (!alive) return sum;
      const auto bounce = bsdf.sample_world(next_pair<Real>(source));
      throughput *= bounce.weight * weight;
      if ((throughput == Real(0)).all()) return sum;
      ray = {vertex.position, bounce.in, hit.surface};
    }
  }

 private:
  template <class Real>
  static Vertex<Real> vertex_at(const Sphere<double>& shape, const Hit<Real>& hit, const Ray<Real>& ray) {
    const Vec3<Real> position = ray.origin + hit.distance * ray.direction;
    const Vec3<Real> outward = shape.normal_at(position).normalized();
    const bool from_outside = outward.dot(ray.direction) < Real(0);
    return {position, from_outside ? outward : Vec3<Real>(-outward), hit.surface};
  }

  int max_depth_;
  Direct direct_;
};

}  // namespace fairlight

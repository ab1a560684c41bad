#pragma once

#include <stdexcept>
#include <utility>

#include <fairlight/estimators/roulette.h>
#include <fairlight/render/direct_light.h>

namespace fairlight {

/// The state of a path: its next ray, and the radiance found so far.
template <class Real>
struct Path {
  Ray<Real> ray;
  Rgb<Real> throughput = Rgb<Real>::Constant(Real(1));
  Rgb<Real> radiance = Rgb<Real>::Constant(Real(0));  ///< [W/(sr m^2)]
  /// The density of the last bounce [1/sr]; 0 after a delta bounce and at the camera.
  Real density = Real(0);
  Real depth = Real(0);  ///< number of bounces so far
};

/// Starts a new path in the lanes `begins`. Their rays are already set.
template <class Real>
void begin_paths(Path<Real>& path, const Mask<Real>& begins) {
  path.throughput = select(begins, Rgb<Real>(Rgb<Real>::Constant(Real(1))), path.throughput);
  path.radiance = select(begins, zero<Rgb<Real>>(), path.radiance);
  path.density = select(begins, Real(0), path.density);
  path.depth = select(begins, Real(0), path.depth);
}

/// Samples diffuse surfaces by `Directions`, a distribution on the hemisphere.
template <template <class> class Directions>
struct BouncesBy {
  template <class Real>
  static Directions<Real> directions() {
    return {};
  }
};

/// Radiance along a ray, by one path: emission, direct light and bounces, each a component.
/// Unbiased with roulette or if every path ends; with a maximum depth, unbiased for the sum up to
/// that depth.
/// Formula  L = sum over depths of throughput x (emission + direct light)
/// Measure  none: an estimate of radiance [W/(sr m^2)]
/// Domain   each lane is a path. Needs a depth if a surface white in a channel encloses the path
/// Random   two dimensions per bounce, one per roulette, and those of the direct light
/// Source   Kajiya 1986; the paper, sections 2 and 3
template <class Bounces, class Direct, class Roulette>
class PathTracer {
 public:
  static constexpr int no_limit = -1;

  /// max_depth: the number of bounces after which a path ends, or no_limit. Throws
  /// std::invalid_argument for a smaller number.
  explicit PathTracer(int max_depth = no_limit, Direct direct = Direct(), Bounces bounces = Bounces(),
                      Roulette roulette = Roulette())
      : max_depth_(max_depth),
        direct_(std::move(direct)),
        bounces_(std::move(bounces)),
        roulette_(std::move(roulette)) {
    if (max_depth < no_limit) throw std::invalid_argument("a maximum depth must be nonnegative");
  }

  /// The radiance of a whole path.
  template <class Real, class Scene, UniformSource<Real> Source>
  Rgb<Real> radiance(const Scene& scene, const Ray<Real>& ray, Source& source) const {
    Path<Real> path{ray};
    for (Mask<Real> alive(true); any(alive);) alive = advance(scene, path, source, alive);
    return path.radiance;
  }

  /// Advances the paths that are alive by one vertex: adds the light found there, samples a bounce,
  /// and returns which paths go on.
  template <class Real, class Scene, UniformSource<Real> Source>
  Mask<Real> advance(const Scene& scene, Path<Real>& path, Source& source, Mask<Real> alive) const {
    const Hit<Real> hit = scene.intersect(path.ray, alive);
    alive = alive && hit.surface >= Real(0);
    const auto surface = to_int(Real(select(alive, hit.surface, Real(0))));
    const Real weight =
        direct_.emission_weight(scene, path.ray, Real(select(alive, hit.surface, Real(0))), path.density);
    path.radiance +=
        select(alive, Rgb<Real>(path.throughput * scene.materials().emission(surface) * weight), zero<Rgb<Real>>());
    if (max_depth_ != no_limit) alive = alive && path.depth < Real(static_cast<Lane<Real>>(max_depth_));
    if (!any(alive)) return alive;

    const Vec3<Real> out = -path.ray.direction;
    const Vec3<Real> position = path.ray.origin + select(alive, hit.distance, Real(0)) * path.ray.direction;
    const Vec3<Real> outward = select(alive, scene.normal_at(surface, position), out);
    const SurfaceBsdf bsdf(scene.materials(), surface, outward, out, bounces_.template directions<Real>());
    const Vertex<Real> vertex{position, bsdf.normal(), hit.surface};
    path.radiance += path.throughput * direct_.template estimate<Real>(scene, vertex, bsdf, source, alive);
    return bounce(path, vertex, bsdf, source, alive);
  }

 private:
  template <class Real, class Bsdf, class Source>
  Mask<Real> bounce(Path<Real>& path, const Vertex<Real>& vertex, const Bsdf& bsdf, Source& source,
                    Mask<Real> alive) const {
    if (direct_.next_event_only() && max_depth_ != no_limit) {
      // After the last bounce a path only looks for light. With shadow rays only, a bounce that is
      // not a delta bounce finds none.
      const Mask<Real> last = path.depth + Real(1) == Real(static_cast<Lane<Real>>(max_depth_));
      if (any(last)) alive = alive && (!last || bsdf.is_single());
      if (!any(alive)) return alive;
    }
    const auto [survives, weight] =
        roulette_.template play<Real>(bsdf.albedo(), path.throughput, path.depth, source);
    alive = alive && survives;
    if (!any(alive)) return alive;
    const Bounce<Real> next = bsdf.sample_world(next_pair<Real>(source));
    path.throughput = select(alive, Rgb<Real>(path.throughput * next.weight * weight), zero<Rgb<Real>>());
    path.ray = {vertex.position, select(alive, next.in, path.ray.direction), vertex.surface};
    path.density = next.density.value();
    path.depth += Real(1);
    return alive && max_channel(path.throughput) > Real(0);
  }

  int max_depth_;
  Direct direct_;
  Bounces bounces_;
  Roulette roulette_;
};

}  // namespace fairlight

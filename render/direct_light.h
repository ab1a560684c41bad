#pragma once

#include <array>
#include <utility>
#include <vector>

#include <fairlight/estimators/choose_light.h>
#include <fairlight/estimators/mis.h>
#include <fairlight/render/traced_scene.h>

namespace fairlight {

/// Below, `Scene` is a TracedScene or a type with the same interface.

/// A point on a surface at which a path reflects. `normal` is the unit normal on the reflecting
/// side.
template <class Real>
struct Vertex {
  Vec3<Real> position;
  Vec3<Real> normal;
  Real surface;
};

/// Samples points of luminaires: spheres by one strategy, rectangles by another.
/// Formula  that of the luminaire's strategy
/// Measure  solid angle [1/sr]
/// Domain   that of the strategies
/// Random   u in [0,1)^2
/// Source   the strategies'
template <template <class> class SphereSampling, template <class> class RectangleSampling = RectangleByArea>
struct PointsBy {
  /// Samples a direction towards luminaire i; `on_it` marks lanes where `from` lies on its surface.
  template <class Real>
  static LightSample<Real> sample(const LightTable<Real>& lights, const Index<Real>& i, const Mask<Real>& on_it,
                                  const Vec3<Real>& from, const Vec2<Real>& u) {
    if (!lights.has_rectangles()) return SphereSampling<Real>(lights.sphere(i, on_it)).sample(from, u);
    const LightSample<Real> flat = RectangleSampling<Real>(lights.rectangle(i, on_it)).sample(from, u);
    if (!lights.has_spheres()) return flat;
    const LightSample<Real> round = SphereSampling<Real>(lights.sphere(i, on_it)).sample(from, u);
    const Mask<Real> is_flat = lights.is_rectangle(i);
    return {select(is_flat, flat.direction, round.direction), select(is_flat, flat.distance, round.distance),
            Density<SolidAngle, Real>(select(is_flat, flat.density.value(), round.density.value()))};
  }

  /// The density with which `sample` draws a direction.
  template <class Real>
  static Density<SolidAngle, Real> pdf(const LightTable<Real>& lights, const Index<Real>& i,
                                       const Mask<Real>& on_it, const Vec3<Real>& from,
                                       const Vec3<Real>& direction) {
    if (!lights.has_rectangles()) return SphereSampling<Real>(lights.sphere(i, on_it)).pdf(from, direction);
    const auto flat = RectangleSampling<Real>(lights.rectangle(i, on_it)).pdf(from, direction);
    if (!lights.has_spheres()) return flat;
    const auto round = SphereSampling<Real>(lights.sphere(i, on_it)).pdf(from, direction);
    return Density<SolidAngle, Real>(select(lights.is_rectangle(i), flat.value(), round.value()));
  }
};

/// Shadow rays carry all direct light. Emission that a bounce hits counts only after a delta
/// bounce, whose direction no shadow ray can sample.
struct NextEventOnly {
  static constexpr bool next_event_only() { return true; }
  template <class Measure, class Real>
  static Real weight(const std::array<Real, 2>&, const std::array<Density<Measure, Real>, 2>&, std::size_t i) {
    return i == 0 ? Real(1) : Real(0);
  }
};

/// Shadow rays and bounces share direct light by a heuristic of multiple importance sampling.
template <class Heuristic = BalanceHeuristic>
struct MisWeighted : Heuristic {
  static constexpr bool next_event_only() { return false; }
};

/// Direct light reflected at a vertex, by shadow rays. `Luminaires` selects one or all (AllLights,
/// UniformLightSampler, LightSampler), `Points` a point, `Sharing` the weight against bounces.
/// Formula  sum over L of  w f Le cos / p_w  for visible points
/// Measure  solid angle, by Points
/// Domain   vertices of paths that start on the lit side of all spheres; see docs/estimators.md
/// Random   two dimensions per shadow ray, and those of the choice
/// Bound    per luminaire max(Le f cos / p_w): by area A max(Le f) / d^2, by cone S max(Le f)
/// Source   Shirley, Wang, Zimmerman 1996; the paper, 3.2 and A.1
template <class Luminaires, class Points = PointsBy<SphereByArea>, class Sharing = NextEventOnly>
class DirectLight {
 public:
  explicit DirectLight(Luminaires luminaires = Luminaires(), Points points = Points(), Sharing sharing = Sharing())
      : luminaires_(std::move(luminaires)), points_(std::move(points)), sharing_(std::move(sharing)) {}

  /// The weight of emission that a bounce of this density hits. 1 at the start of a path and after
  /// a delta bounce (density 0).
  template <class Real, class Scene>
  Real emission_weight(const Scene& scene, const Ray<Real>& ray, const Real& surface, const Real& density) const {
    const Mask<Real> single = density == Real(0);
    if (sharing_.next_event_only()) return select(single, Real(1), Real(0));
    const LightTable<Real>& lights = scene.lights();
    const Real light = lights.index(to_int(surface));
    const Mask<Real> found = !single && light >= Real(0);
    if (!any(found)) return Real(1);
    const Index<Real> i = to_int(Real(select(found, light, Real(0))));
    const auto by_light = points_.pdf(lights, i, ray.origin_primitive == surface, ray.origin, ray.direction);
    const Real chosen = seen_from(lights, ray.origin).template probability<Real>(lights.size(), i);
    const Density<SolidAngle, Real> by_bounce(select(found, density, Real(1)));
    const Real shared = sharing_.weight(std::array{chosen, Real(1)}, std::array{by_light, by_bounce}, 1);
    // Rounding can put a hit beyond the rim of a luminaire, outside the support of its light
    // sampler. Such a hit gets weight 0: rounding misses as much inside the rim, and shadow rays
    // count all of that. Small lights far away have wide rims.
    const Mask<Real> beyond = found && by_light.value() == Real(0) && chosen > Real(0);
    return select(found, select(beyond, Real(0), shared), Real(1));
  }

  /// Whether only shadow rays look for light, except after a delta bounce.
  bool next_event_only() const { return sharing_.next_event_only(); }

  template <class Real, class Scene, UniformSource<Real> Source, class Bsdf>
  Rgb<Real> estimate(const Scene& scene, const Vertex<Real>& vertex, const Bsdf& bsdf, Source& source,
                     const Mask<Real>& asked = Mask<Real>(true)) const {
    const LightTable<Real>& lights = scene.lights();
    if (lights.size() == 0) return zero<Rgb<Real>>();
    const auto& choice = seen_from(lights, vertex.position);
    const auto term = [&](const auto& i, Source& numbers) {
      const Index<Real> light(i);
      const Real chosen = next_event_only() ? Real(1) : choice.template probability<Real>(lights.size(), light);
      return from(light, chosen, scene, vertex, bsdf, numbers, asked);
    };
    return choice.template sum<Real>(lights.size(), source, term);
  }

 private:
  // The choice of luminaires as seen from a point.
  template <class Real>
  decltype(auto) seen_from(const LightTable<Real>& lights, const Vec3<Real>& point) const {
    if constexpr (requires { luminaires_.seen_from(lights, point); }) {
      return luminaires_.seen_from(lights, point);
    } else {
      return (luminaires_);
    }
  }

  // The direct light from one luminaire. A vertex on the luminaire itself sees its inner side, so
  // it receives nothing where it reflects outwards.
  template <class Real, class Scene, class Source, class Bsdf>
  Rgb<Real> from(const Index<Real>& light, const Real& chosen, const Scene& scene, const Vertex<Real>& vertex,
                 const Bsdf& bsdf, Source& source, const Mask<Real>& asked) const {
    const LightTable<Real>& lights = scene.lights();
    const Real surface = lights.surface(light);
    const auto [direction, distance, density] =
        points_.sample(lights, light, vertex.surface == surface, vertex.position, next_pair<Real>(source));
    const Mask<Real> exists = asked && density.value() > Real(0);
    const Vec3<Real> towards = select(exists, direction, vertex.normal);
    const Rgb<Real> reflected = bsdf.eval_world(towards);
    const Mask<Real> counts = exists && max_channel(reflected) > Real(0);
    if (!any(counts)) return zero<Rgb<Real>>();
    const Mask<Real> seen =
        counts && scene.visible({vertex.position, towards, vertex.surface}, distance, surface, counts);
    Real factor = vertex.normal.dot(towards) / select(exists, density.value(), Real(1));
    if (!sharing_.next_event_only()) {
      factor *= sharing_.weight(std::array{chosen, Real(1)}, std::array{density, bsdf.pdf_world(towards)}, 0);
    }
    return select(seen, Rgb<Real>(lights.emission(light) * reflected * factor), zero<Rgb<Real>>());
  }

  Luminaires luminaires_;
  Points points_;
  Sharing sharing_;
};

/// Samples one luminaire of a scene with probability proportional to its power.
template <class Real = double>
LightSampler<PowerChoice<Real>> one_by_power(const Scene& scene) {
  std::vector<double> powers;
  for (const Luminaire& light : scene.luminaires()) powers.push_back(power_of(light));
  return LightSampler(PowerChoice<Real>(powers));
}

/// Samples one luminaire of a scene by its approximate contribution to the vertex: see
/// LightTable::contribution.
struct ContributionLightSampler {
  template <class Real>
  static auto seen_from(const LightTable<Real>& lights, const Vec3<Real>& point) {
    const auto weight = [&lights, point](const Index<Real>& i) { return lights.contribution(i, point); };
    return LightSampler(ContributionChoice<Real, decltype(weight)>(lights.size(), weight));
  }
};

/// No shadow rays: only bounces find light, and emission counts at every depth.
/// Source   Kajiya 1986
struct NoDirectLight {
  template <class Real, class Scene>
  static Real emission_weight(const Scene&, const Ray<Real>&, const Real& /*surface*/, const Real& /*density*/) {
    return Real(1);
  }
  static constexpr bool next_event_only() { return false; }

  template <class Real, class Scene, UniformSource<Real> Source, class Bsdf>
  static Rgb<Real> estimate(const Scene&, const Vertex<Real>&, const Bsdf&, Source&, const Mask<Real>&) {
    return zero<Rgb<Real>>();
  }
};

}  // namespace fairlight

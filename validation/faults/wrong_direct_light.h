#pragma once

#include <fairlight/estimators/roulette.h>
#include <fairlight/render/direct_light.h>

/// Wrong strategies for direct light on a path, each a bug that a project shipped, or of the class
/// of one.
namespace fairlight::faults {

/// Counts emission at every depth, besides the shadow rays.
/// On record: the paper, A.2.
struct EmissionTwice : DirectLight<AllLights> {
  template <class Real, class Scene>
  static Real emission_weight(const Scene&, const Ray<Real>&, const Real&, const Real&) {
    return Real(1);
  }
  static constexpr bool next_event_only() { return false; }
};

/// Luminaires that the camera sees directly are black.
/// On record: mitsuba3 #1540.
struct EmissionUnseen : DirectLight<AllLights> {
  template <class Real, class Scene>
  static Real emission_weight(const Scene&, const Ray<Real>&, const Real&, const Real&) {
    return Real(0);
  }
};

/// Plays roulette before the shadow ray, without dividing its light by the probability.
/// On record: vk_raytrace #13, openmc #241.
struct LightAfterRoulette : DirectLight<AllLights> {
  template <class Real, class Scene, class Source, class Bsdf>
  Rgb<Real> estimate(const Scene& scene, const Vertex<Real>& vertex, const Bsdf& bsdf, Source& source,
                     const Mask<Real>& asked) const {
    const Survival<Real> survival =
        RouletteByReflectance<>::play<Real>(bsdf.albedo(), bsdf.albedo(), Real(0), source);
    return DirectLight<AllLights>::estimate<Real>(scene, vertex, bsdf, source, asked && survival.alive);
  }
};

/// Leaves the light in mirrors to shadow rays, which cannot find it.
/// On record: three-gpu-pathtracer #174.
struct MirrorsToShadowRays : DirectLight<AllLights> {
  template <class Real, class Scene>
  static Real emission_weight(const Scene&, const Ray<Real>& ray, const Real&, const Real&) {
    return select(ray.origin_primitive < Real(0), Real(1), Real(0));
  }
};

/// Gives the direction of a mirror the density 1, so that it shares its light with shadow rays.
/// On record: three-gpu-pathtracer #174.
struct MirrorsWithDensity : DirectLight<AllLights, PointsBy<SphereByCone>, MisWeighted<>> {
  template <class Real, class Scene>
  Real emission_weight(const Scene& scene, const Ray<Real>& ray, const Real& surface, const Real& density) const {
    const Mask<Real> mirrored = density == Real(0) && ray.origin_primitive >= Real(0);
    return DirectLight::emission_weight(scene, ray, surface, Real(select(mirrored, Real(1), density)));
  }
};

/// Evaluates the density of the shadow ray one metre before the vertex.
/// On record: the class of mitsuba aa325039f.
struct DensityAtWrongVertex : PointsBy<SphereByCone> {
  template <class Real>
  static Density<SolidAngle, Real> pdf(const LightTable<Real>& lights, const Index<Real>& i,
                                       const Mask<Real>& on_it, const Vec3<Real>& from,
                                       const Vec3<Real>& direction) {
    return PointsBy<SphereByCone>::pdf(lights, i, on_it, Vec3<Real>(from - direction), direction);
  }
};

/// Counts the light that a bounce finds in full, besides the share of the shadow rays.
/// On record: Moer #59.
struct SharedByShadowRaysAlone : MisWeighted<> {
  template <class Measure, class Real>
  static Real weight(const std::array<Real, 2>& n, const std::array<Density<Measure, Real>, 2>& p, std::size_t i) {
    return i == 0 ? MisWeighted<>::weight(n, p, i) : Real(1);
  }
};

/// Weights shadow rays by the power heuristic, and bounces by the balance heuristic.
/// Of the class of Moer #59.
struct MixedHeuristics : MisWeighted<> {
  template <class Measure, class Real>
  static Real weight(const std::array<Real, 2>& n, const std::array<Density<Measure, Real>, 2>& p, std::size_t i) {
    return i == 0 ? PowerHeuristic::weight(n, p, i) : BalanceHeuristic::weight(n, p, i);
  }
};

/// Shadow rays pick one light, but the weights of bounces leave out the probability of the pick.
/// On record: redner #56.
struct ChanceForgottenByBounces : DirectLight<UniformLightSampler, PointsBy<SphereByCone>, MisWeighted<>> {
  template <class Real, class Scene>
  Real emission_weight(const Scene& scene, const Ray<Real>& ray, const Real& surface, const Real& density) const {
    return DirectLight<AllLights, PointsBy<SphereByCone>, MisWeighted<>>().emission_weight(scene, ray, surface,
                                                                                           density);
  }
};

/// A point of an emitting rectangle, off its plane by rounding, sees all of the rectangle. A bug of
/// fairlight itself, which `lit_box` found.
struct RectanglesLightThemselves {
  using Right = PointsBy<SphereByArea, RectangleBySolidAngle>;

  template <class Real>
  static LightSample<Real> sample(const LightTable<Real>& lights, const Index<Real>& i, const Mask<Real>&,
                                  const Vec3<Real>& from, const Vec2<Real>& u) {
    return Right::sample(lights, i, Mask<Real>(false), from, u);
  }
  template <class Real>
  static Density<SolidAngle, Real> pdf(const LightTable<Real>& lights, const Index<Real>& i, const Mask<Real>&,
                                       const Vec3<Real>& from, const Vec3<Real>& direction) {
    return Right::pdf(lights, i, Mask<Real>(false), from, direction);
  }
};

}  // namespace fairlight::faults

#pragma once

#include <cmath>

#include <fairlight/render/strategies.h>
#include <fairlight/validation/faults/wrong_direct_light.h>

/// Wrong path tracers, and scenes that answer rays wrongly. Each is a bug that a project shipped,
/// or of the class of one.
namespace fairlight::faults {

/// Takes all terms up to a depth for the whole series.
/// On record: rpt #5.
template <class Tracer, int depth>
struct Truncated : Tracer {
  Truncated() : Tracer(depth) {}
};

/// One bounce more than requested.
/// On record: pbrt-v3 #69.
template <class Tracer>
struct OneBounceMore : Tracer {
  explicit OneBounceMore(int depth) : Tracer(depth + 1) {}
};

/// Clamps samples to [0,1] before averaging.
/// On record: Smerity/montelight-cpp.
template <class Tracer>
struct Clamped : Tracer {
  template <class Real, class Scene, class Source>
  Rgb<Real> radiance(const Scene& scene, const Ray<Real>& ray, Source& source) const {
    Rgb<Real> radiance = Tracer::template radiance<Real>(scene, ray, source);
    for (Real& channel : radiance) channel = select(channel < Real(1), channel, Real(1));
    return radiance;
  }
};

/// Drops bright samples as errors.
/// On record: the class of three-gpu-pathtracer #825.
template <class Tracer>
struct WithoutOutliers : Tracer {
  template <class Real, class Scene, class Source>
  Rgb<Real> radiance(const Scene& scene, const Ray<Real>& ray, Source& source) const {
    const Rgb<Real> radiance = Tracer::template radiance<Real>(scene, ray, source);
    return select(max_channel(radiance) < Real(6), radiance, zero<Rgb<Real>>());
  }
};

/// A tracer whose scene answers rays wrongly.
template <class Tracer, template <class> class InScene>
struct TracerIn : Tracer {
  template <class Real, class Scene, class Source>
  Rgb<Real> radiance(const Scene& scene, const Ray<Real>& ray, Source& source) const {
    return Tracer::template radiance<Real>(InScene<Scene>{scene}, ray, source);
  }
};

/// A scene that passes everything on unchanged.
template <class Scene>
struct SceneAsIs {
  const Scene& scene;

  const auto& materials() const { return scene.materials(); }
  const auto& lights() const { return scene.lights(); }
  auto normal_at(const auto& surface, const auto& position) const { return scene.normal_at(surface, position); }
  template <class Real>
  Hit<Real> intersect(const Ray<Real>& ray, const Mask<Real>& asked) const {
    return scene.intersect(ray, asked);
  }
  template <class Real>
  Mask<Real> visible(const Ray<Real>& ray, Real distance, Real target, const Mask<Real>& asked) const {
    return scene.visible(ray, distance, target, asked);
  }
};

/// Treats a hit nearer than 10^-k metres as one of the surface that the ray left, and ignores it.
/// On record: SORT #29.
template <int k>
struct NearHitsIgnored {
  template <class Scene>
  struct In : SceneAsIs<Scene> {
    template <class Real>
    Hit<Real> intersect(const Ray<Real>& ray, const Mask<Real>& asked) const {
      const Hit<Real> hit = this->scene.intersect(ray, asked);
      const Mask<Real> near = hit.distance < rounded<Real>(std::pow(0.1, k));
      return {select(near, Real(infinity<Real>), hit.distance), select(near, Real(-1), hit.surface)};
    }
  };
};

/// A shadow ray does not know its origin surface, and by rounding hits it again.
/// On record: mitsuba3 #785.
template <class Scene>
struct ShadowedByItself : SceneAsIs<Scene> {
  template <class Real>
  Mask<Real> visible(const Ray<Real>& ray, Real distance, Real target, const Mask<Real>& asked) const {
    return this->scene.visible({ray.origin, ray.direction, Real(-1)}, distance, target, asked);
  }
};

/// Starts shadow rays one millimetre from the surface, to miss it. This suits scenes of one size
/// only.
/// On record: GLSL-PathTracer #35.
template <class Scene>
struct ShadowsFromAMillimetre : SceneAsIs<Scene> {
  template <class Real>
  Mask<Real> visible(const Ray<Real>& ray, Real distance, Real target, const Mask<Real>& asked) const {
    const Real start = rounded<Real>(1e-3);
    return this->scene.visible({ray.origin + start * ray.direction, ray.direction, Real(-1)}, distance - start,
                               target, asked);
  }
};

/// Starts shadow rays at a distance of 1e-3 times that from the world origin.
/// On record: mitsuba3 #1962.
template <class Scene>
struct ShadowsByTheOrigin : SceneAsIs<Scene> {
  template <class Real>
  Mask<Real> visible(const Ray<Real>& ray, Real distance, Real target, const Mask<Real>& asked) const {
    const Real start = rounded<Real>(1e-3) * ray.origin.norm();
    return this->scene.visible({ray.origin + start * ray.direction, ray.direction, ray.origin_primitive},
                               distance - start, target, asked);
  }
};

/// Takes surface 0 for no surface.
/// Of the class of an index used as a truth value.
template <class Scene>
struct SurfaceZeroIsNone : SceneAsIs<Scene> {
  template <class Real>
  Mask<Real> visible(const Ray<Real>& ray, Real distance, Real target, const Mask<Real>& asked) const {
    return target != Real(0) && this->scene.visible(ray, distance, target, asked);
  }
};

/// Stores two coordinates of a normal and takes the positive root for the third, as in a normal
/// map.
/// Of the class of ByroRedux #3922.
template <class Scene>
struct NormalsUpwards : SceneAsIs<Scene> {
  auto normal_at(const auto& surface, const auto& position) const {
    using std::abs;
    auto normal = this->scene.normal_at(surface, position);
    normal.z() = abs(normal.z());
    return normal;
  }
};

/// Shares light by mixed heuristics, with any other strategies.
template <class Real>
struct SharedByMixedHeuristics : DirectLight<ChosenLuminaires<Real>, ChosenPoints, MixedHeuristics> {
  using Right = DirectLight<ChosenLuminaires<Real>, ChosenPoints, MixedHeuristics>;
  SharedByMixedHeuristics(const Strategies& strategies, const Scene& scene)
      : Right(ChosenLuminaires<Real>(strategies, scene), {strategies.light_sampling}) {}
};

/// Drops directions of low density as errors.
/// On record: dspbr-pt #5.
template <class Real>
struct GrazingClipped : CosineHemisphere<Real> {
  Density<SolidAngle, Real> pdf(const Vec3<Real>& w) const {
    const Real p = CosineHemisphere<Real>::pdf(w).value();
    return Density<SolidAngle, Real>(select(w.z() < rounded<Real>(0.1), Real(infinity<Real>), p));
  }
};

}  // namespace fairlight::faults

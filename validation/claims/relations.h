#pragma once

#include <fairlight/render/strategies.h>
#include <fairlight/validation/checks/padded_sets.h>
#include <fairlight/validation/claims/chosen_tracer.h>
#include <fairlight/validation/claims/radiance.h>
#include <fairlight/validation/claims/related_scenes.h>

namespace fairlight {

/// Relations that need no reference: of two scenes the one's picture is known from the other's.

/// A component as it is; a fault puts another in its place.
template <class T>
using AsItIs = T;

/// The path tracer of some strategies, in every arithmetic.
template <template <class> class Wrong = AsItIs>
auto chosen_tracers(const RenderSettings& settings, const Scene& scene) {
  return [=]<class Real>(std::type_identity<Real>) {
    if constexpr (std::is_same_v<Wrong<int>, int>) {
      return ChosenTracer<Real>(settings, scene);
    } else {
      auto tracer = chosen_tracer<Real>(Strategies(settings, scene), scene);
      return Wrong<decltype(tracer)>{tracer};
    }
  };
}

/// What surfaces reflect along the rays of a view's camera. What the camera sees of the luminaires themselves is left out:
/// it is the same numbers many times over, and at a luminaire's rim a matter of an ulp.
template <template <class> class Wrong = AsItIs>
class ReflectedLight {
 public:
  ReflectedLight(const View& view, RenderSettings settings)
      : camera_(view.camera), all_(tracer(view, settings)), seen_(tracer(view, without_bounces(settings))) {}

  /// In grey, through a place of the picture, of which (0,0) is the upper left corner and (1,1) the lower right one.
  template <class Real, class Source>
  Real operator()(std::type_identity<Real> real, const Vec2<Real>& place, Source& source) const {
    const Rgb<Real> light = along(real, camera_.template ray<Real>(place.x(), place.y(), 1, 1, source), source);
    return (light[0] + light[1] + light[2]) / Real(3);
  }

  /// Along a ray, in colour.
  template <class Real, class Source>
  Rgb<Real> along(std::type_identity<Real> real, const Ray<Real>& ray, Source& source) const {
    const Rgb<Real> seen = seen_.along(ray, real, source);
    return all_.along(ray, real, source) - seen;
  }

 private:
  static RenderSettings without_bounces(RenderSettings settings) {
    settings.max_depth = 0;
    return settings;
  }
  static auto tracer(const View& view, const RenderSettings& settings) {
    return RadianceAlong(view.scene, Ray<double>{{0, 0, 0}, {0, 0, 1}, -1},
                         chosen_tracers<Wrong>(settings, view.scene));
  }
  using Tracer = decltype(tracer(std::declval<View>(), RenderSettings()));

  Camera camera_;
  Tracer all_, seen_;
};

/// Two views by the same strategies.
struct RelatedViews {
  std::string name;  ///< of the relation: scale, rotation ...
  std::string statement;
  View one, other;
  RenderSettings settings;
  double factor = 1;  ///< of the other's picture over the one's
};

/// Every path of the one view is a path of the other, by the same numbers, and brings so many times as much: to 4 ulp, where nothing is
/// rounded otherwise, as with factors of 2.
template <class Real, template <class> class Wrong = AsItIs>
Claim same_paths(const RelatedViews& views) {
  return {.name = views.name + real_suffix<Real>(),
          .kind = "constant",
          .subjects = {"PathTracer", "DirectLight"},
          .statement = views.statement + ", path by path",
          .source = "the light transport equation",
          .margin_factor = 1,
          .check =
              [=](const Trial& trial) {
                const ReflectedLight<Wrong> one(views.one, views.settings), other(views.other, views.settings);
                const auto ratio = [&](auto& source) {
                  const Vec2<Real> place = next_pair<Real>(source);
                  auto same = source;
                  const Real a = one(std::type_identity<Real>{}, place, source) * rounded<Real>(views.factor);
                  const Real b = other(std::type_identity<Real>{}, place, same);
                  return Real(select(a == b, Real(1), Real(b / a)));
                };
                return check_constant<Real>(trial, 1, 4, ratio);
              },
          .real = real_name<Real>()};
}

/// How the pictures of two views are compared by their means.
struct PictureMeans {
  double largest;  ///< what a path brings at most, in either
  double mean;     ///< of what surfaces reflect, in grey: no more than it is
  double margin_factor;
  bool same_numbers = false;  ///< both paths follow the same numbers, so that they part where roundings do alone
  double rounding = 0;        ///< of coordinates, relative to the mean
};

/// The mean of the two pictures' difference: paths through one place of both.
template <template <class> class Wrong = AsItIs>
auto same_means(const RelatedViews& views, const PictureMeans& means) {
  const auto draw = [one = ReflectedLight<Wrong>(views.one, views.settings),
                     other = ReflectedLight<Wrong>(views.other, views.settings), factor = views.factor,
                     means]<class Real>(std::type_identity<Real> real, auto& source) {
    const Vec2<Real> place = next_pair<Real>(source);
    auto same = source;
    const Real a = one(real, place, source) * rounded<Real>(factor);
    return Real(other(real, place, means.same_numbers ? same : source) - a);
  };
  return Estimand{views.name,
                  {"PathTracer", "DirectLight"},
                  views.statement + (means.same_numbers ? ", path by path" : ""),
                  "the light transport equation",
                  means.margin_factor,
                  {{0, -means.largest, means.largest, 0, means.mean, Sides::both, means.rounding}},
                  draw};
}

/// What is compared of sets, and sets of twice as many.
struct SampledView {
  View view;
  RenderSettings settings;
  double largest, mean;  ///< as above
  std::uint32_t n;
};

/// The mean over sets of n points is that over sets of 2n, which are other points: those are spread over twice as many cells.
template <class Real, class Numbers>
Claim twice_the_samples(const std::string& kind, const std::string& subject, const SampledView& sampled) {
  return {.name = sampled.view.name + ".relation.twice." + kind + real_suffix<Real>(),
          .kind = "mean",
          .subjects = {subject, "VertexSource", "PathTracer"},
          .statement = "sets of " + std::to_string(2 * sampled.n) + " samples have the mean of sets of " +
                       std::to_string(sampled.n),
          .source = "the same integral",
          .margin_factor = 1,
          .check =
              [=](const Trial& trial) {
                const TracedScene<Real> scene(sampled.view.scene);
                const auto tracer =
                    chosen_tracer<Real>(Strategies(sampled.settings, sampled.view.scene), sampled.view.scene);
                const Numbers twice(StreamKey(trial.seed, trial.claim + " twice"), 2 * sampled.n);
                const auto grey = [&](const auto& numbers) {
                  auto camera = numbers.at(0);
                  const Vec2<Real> place = next_pair<Real>(camera);
                  const Path<Real> path{sampled.view.camera.template ray<Real>(place.x(), place.y(), 1, 1, camera)};
                  const Rgb<Real> radiance = followed<Real>(tracer, scene, path, numbers);
                  return Real((radiance[0] + radiance[1] + radiance[2]) / Real(3));
                };
                const Reference reference{0, -sampled.largest, sampled.largest, 0, sampled.mean};
                return check_sets<Real, Numbers>(trial, {reference}, sampled.n, [&](const auto& numbers) {
                  const PathNumbers<Real, Numbers> even{twice, numbers.pixel, numbers.sample + numbers.sample};
                  const PathNumbers<Real, Numbers> odd{twice, numbers.pixel, even.sample + Word<Real>(1u)};
                  return Real(grey(numbers) - (grey(even) + grey(odd)) * Real(0.5));
                });
              },
          .real = real_name<Real>()};
}

}  // namespace fairlight

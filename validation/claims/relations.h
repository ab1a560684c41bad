#pragma once

#include <fairlight/render/strategies.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/checks/chosen_tracer.h>
#include <fairlight/validation/checks/padded_sets.h>
#include <fairlight/validation/claims/radiance.h>
#include <fairlight/validation/claims/related_scenes.h>

namespace fairlight {

/// Relations that need no reference: the picture of one scene is known from that of another.

/// A component, unchanged; a fault puts another in its place.
template <class T>
using AsItIs = T;

/// The path tracer of given strategies, in every arithmetic.
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

/// The light that surfaces reflect along camera rays. It leaves out the luminaires that the camera
/// sees directly: their value is mostly constant, and at the rim of a luminaire depends on an ulp.
template <template <class> class Wrong = AsItIs>
class ReflectedLight {
 public:
  ReflectedLight(const View& view, RenderSettings settings)
      : camera_(view.camera), all_(tracer(view, settings)), seen_(tracer(view, without_bounces(settings))) {}

  /// The reflected light in grey, through a place of the picture. (0,0) is the upper left corner,
  /// (1,1) the lower right one.
  template <class Real, class Source>
  Real operator()(std::type_identity<Real> real, const Vec2<Real>& place, Source& source) const {
    return mean_channel(along(real, camera_.template ray<Real>(place.x(), place.y(), 1, 1, source), source));
  }

  /// The reflected light along a ray, in colour.
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
    return RadianceAlong(view.scene, chosen_tracers<Wrong>(settings, view.scene));
  }
  using Tracer = decltype(tracer(std::declval<View>(), RenderSettings()));

  Camera camera_;
  Tracer all_, seen_;
};

/// Two views by the same strategies.
struct RelatedViews {
  std::string name;  ///< the relation: scale, rotation ...
  std::string statement;
  View one, other;
  RenderSettings settings;
  double factor = 1;  ///< the picture of `other` divided by that of `one`
};

/// Tests that a path of `one` and a path of `other` with the same numbers have radiances of the
/// ratio `factor`, to 4 ulp. It is for relations that round alike, such as factors of 2.
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

/// The parameters of a comparison of the mean pictures of two views.
struct PictureMeans {
  double largest;  ///< the most that a path brings, in either
  double mean;     ///< the light that surfaces reflect, in grey, or less
  double margin_factor;
  bool same_numbers = false;  ///< both paths use the same numbers, and differ by rounding only
  double rounding = 0;        ///< of coordinates, relative to the mean
};

/// The mean of the difference of the two pictures, from paths through the same place of both.
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
  return estimand(views.name, {"PathTracer", "DirectLight"},
                  views.statement + (means.same_numbers ? ", path by path" : ""), "the light transport equation",
                  {{0, -means.largest, means.largest, 0, means.mean, Sides::both, means.rounding}}, draw,
                  means.margin_factor);
}

/// The parameters of a comparison of sets with sets of twice as many samples.
struct SampledView {
  View view;
  RenderSettings settings;
  double largest, mean;  ///< as in PictureMeans
  std::uint32_t n;
};

/// Tests that sets of n points have the mean of sets of 2n. The points differ, as the latter are
/// spread over twice as many cells.
template <class Real, class Numbers>
Claim twice_the_samples(RandomNumbers kind, const std::string& subject, const SampledView& sampled) {
  return {.name = formatted("%s.relation.twice.%s%s", sampled.view.name.c_str(), name_of(kind),
                            real_suffix<Real>().c_str()),
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
                const auto light = [&](const auto& numbers) {
                  auto camera = numbers.at(0);
                  const Vec2<Real> place = next_pair<Real>(camera);
                  const Path<Real> path{sampled.view.camera.template ray<Real>(place.x(), place.y(), 1, 1, camera)};
                  return mean_channel(followed<Real>(tracer, scene, path, numbers));
                };
                const Reference reference{0, -sampled.largest, sampled.largest, 0, sampled.mean};
                return check_sets<Real, Numbers>(trial, {reference}, sampled.n, [&](const auto& numbers) {
                  const PathNumbers<Real, Numbers> even{twice, numbers.pixel, numbers.sample + numbers.sample};
                  const PathNumbers<Real, Numbers> odd{twice, numbers.pixel, even.sample + Word<Real>(1u)};
                  return Real(light(numbers) - (light(even) + light(odd)) * Real(0.5));
                });
              },
          .real = real_name<Real>()};
}

}  // namespace fairlight

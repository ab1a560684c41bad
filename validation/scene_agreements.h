#pragma once

#include <fairlight/render/render_image.h>
#include <fairlight/render/strategies.h>
#include <fairlight/validation/radiance.h>

namespace fairlight {

/// What two sets of strategies may be compared by, in a built-in scene.
struct SceneComparison {
  std::string scene;
  int max_depth;   ///< of both
  double largest;  ///< what a path's vertices bring at most, with either, but for the emission that the camera sees
  double mean;     ///< of the picture, in grey: no more than it is
  double margin_factor;   ///< relative to the mean
  double tail_slack = 0;  ///< what lies beyond `largest`, in the mean
};

/// The mean of a whole picture by two sets of strategies, which must be the same: paths from one point of the image and of
/// the lens, each followed by both, so that what the camera sees of the lights themselves is no difference.
inline auto strategies_agree(const std::string& name, std::vector<std::string> subjects,
                             const SceneComparison& comparison, RenderSettings one, RenderSettings other) {
  one.scene = other.scene = comparison.scene;
  one.max_depth = other.max_depth = comparison.max_depth;
  const View view = view_of(one);
  const auto tracer = [&](const RenderSettings& settings) {
    const auto make = [scene = view.scene, settings]<class Real>(std::type_identity<Real>) {
      return chosen_tracer<Real>(Strategies(settings, scene), scene);
    };
    return RadianceAlong(view.scene, Ray<double>{{0, 0, 0}, {0, 0, 1}, -1}, make);
  };
  const auto draw = [camera = view.camera, a = tracer(one), b = tracer(other)]<class Real>(
                        std::type_identity<Real> real, auto& source) {
    const Vec2<Real> place = next_pair<Real>(source);
    const Ray<Real> ray = camera.template ray<Real>(place.x(), place.y(), 1, 1, source);
    const Rgb<Real> difference = a.along(ray, real, source) - b.along(ray, real, source);
    return Real((difference[0] + difference[1] + difference[2]) / Real(3));
  };
  return Experiment{name,
                    std::move(subjects),
                    "the mean of the picture of " + comparison.scene + " is the same by both strategies",
                    "the same integral",
                    comparison.margin_factor,
                    {{0, -comparison.largest, comparison.largest, comparison.tail_slack, comparison.mean}},
                    draw};
}

}  // namespace fairlight

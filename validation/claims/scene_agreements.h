#pragma once

#include <fairlight/render/render_image.h>
#include <fairlight/render/strategies.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/checks/chosen_tracer.h>
#include <fairlight/validation/checks/padded_sets.h>
#include <fairlight/validation/claims/radiance.h>

namespace fairlight {

/// The parameters of a comparison of two sets of strategies, in a built-in scene.
struct SceneComparison {
  std::string scene;
  int max_depth;         ///< of both
  double darkest;        ///< the least difference of a path (one - other), in grey
  double brightest;      ///< the largest difference; directly seen emission cancels
  double mean;           ///< the mean of the picture in grey, or less
  double margin_factor;  ///< relative to the mean
};

/// The mean of a whole picture by two sets of strategies, which must agree. Both follow a path from
/// the same point of the image and of the lens, so that directly seen lights cancel.
inline auto strategies_agree(const std::string& name, std::vector<std::string> subjects,
                             const SceneComparison& comparison, RenderSettings one, RenderSettings other) {
  one.scene = other.scene = comparison.scene;
  one.max_depth = other.max_depth = comparison.max_depth;
  const View view = view_of(one);
  const auto tracer = [&](const RenderSettings& settings) {
    const auto make = [scene = view.scene, settings]<class Real>(std::type_identity<Real>) {
      return ChosenTracer<Real>(settings, scene);
    };
    return RadianceAlong(view.scene, make);
  };
  // The numbers of a vertex: two for each shadow ray to a luminaire, one for the choice of a
  // luminaire, one for roulette, two for a bounce.
  const std::size_t numbers =
      static_cast<std::size_t>(comparison.max_depth) * (2 * view.scene.luminaires().size() + 4);
  const auto draw = [numbers, camera = view.camera, a = tracer(one), b = tracer(other)]<class Real>(
                        std::type_identity<Real> real, auto& source) {
    const Vec2<Real> place = next_pair<Real>(source);
    const Ray<Real> ray = camera.template ray<Real>(place.x(), place.y(), 1, 1, source);
    auto ahead = source.take(numbers);
    const Rgb<Real> by_other = b.along(ray, real, ahead);
    return mean_channel(Rgb<Real>(a.along(ray, real, source) - by_other));
  };
  return estimand(name, std::move(subjects),
                  "the mean of the picture of " + comparison.scene + " is the same by both strategies",
                  "the same integral", {{0, comparison.darkest, comparison.brightest, 0, comparison.mean}}, draw,
                  comparison.margin_factor);
}

/// The picture has at least the mean that its comparisons are relative to. If it had not, their
/// margins would be wider than stated. `most` is the most that a path brings, in grey.
inline auto presumed_mean(const std::string& name, const SceneComparison& comparison, double most,
                          RenderSettings settings) {
  settings.scene = comparison.scene;
  settings.max_depth = comparison.max_depth;
  const View view = view_of(settings);
  const auto make = [scene = view.scene, settings]<class Real>(std::type_identity<Real>) {
    return ChosenTracer<Real>(settings, scene);
  };
  const auto draw = [camera = view.camera, tracer = RadianceAlong(view.scene, make)]<class Real>(
                        std::type_identity<Real> real, auto& source) {
    const Vec2<Real> place = next_pair<Real>(source);
    return mean_channel(tracer.along(camera.template ray<Real>(place.x(), place.y(), 1, 1, source), real, source));
  };
  return estimand(name, {"PathTracer", "DirectLight"},
                  "the picture of " + comparison.scene + " has the mean that margins are relative to, or more",
                  "a declared bound, that was measured",
                  {{comparison.mean, 0, most, 0, comparison.mean, Sides::not_below}}, draw, 20);
}

/// A square of a picture; (0,0) is the upper left corner, (1,1) the lower right one.
struct PictureSquare {
  double left = 0, top = 0, side = 1;
};

/// Around the light of cornell-simple as its camera sees it; the light ends a pixel inside the
/// border.
inline constexpr PictureSquare around_the_light_of_cornell_simple{0.48, 0.2775, 0.04};

/// Tests the error of packets of floats: the same paths in packets and, lane by lane from the same
/// numbers, in double. They differ only where a float rounds across an edge.
/// `part(type_identity<Real>, ray, source)` gives the compared light along a camera ray, in grey,
/// at most `largest`. Outside the square it must be 0. The margin is relative to `mean`, that of
/// the whole picture.
template <class Part>
Claim floats_against_double(const std::string& name, const View& view, double largest, double mean,
                            double margin_factor, Part part, const PictureSquare& square = {}) {
  const auto draw = [camera = view.camera, part, square]<class Real>(std::type_identity<Real> real, auto& source) {
    const Vec2<Real> place = next_pair<Real>(source);
    const Real x = rounded<Real>(square.left) + rounded<Real>(square.side) * place.x();
    const Real y = rounded<Real>(square.top) + rounded<Real>(square.side) * place.y();
    return Real(rounded<Real>(square.side * square.side) *
                part(real, camera.template ray<Real>(x, y, 1, 1, source), source));
  };
  largest *= square.side * square.side;
  const PairedDraws draws = paired_draws<Packet>(body_of<double>(draw), body_of<Packet>(draw), 1);
  return {.name = name,
          .kind = "agreement",
          .subjects = {"PathTracer"},
          .statement = "the mean of the picture in packets of floats is that in double, path by path",
          .source = "the same integral",
          .margin_factor = margin_factor,
          .check =
              [=](const Trial& trial) {
                const std::vector<Reference> floats{{0, -largest, largest, 0, mean}};
                return test_means(trial, rounded_references<Packet>(floats),
                                  draws.double_minus_packet(StreamKey(trial.seed, trial.claim), floats));
              },
          .real = real_name<Packet>()};
}

/// Tests the mean of a picture with the numbers of sets against that with independent numbers. Both
/// follow a path from the same place of the image, a point of the set. A draw of the test is the
/// mean over a whole set.
template <class Real, class Numbers>
Claim sets_agree(const std::string& name, std::vector<std::string> subjects, const SceneComparison& comparison,
                 RenderSettings settings, std::uint32_t n = 4) {
  settings.scene = comparison.scene;
  settings.max_depth = comparison.max_depth;
  subjects.insert(subjects.end(), {"VertexSource", "IndependentNumbers", "PathTracer"});
  return {.name = name + real_suffix<Real>(),
          .kind = "mean",
          .subjects = std::move(subjects),
          .statement = "the mean of the picture of " + comparison.scene + " is the same by sets of " +
                       std::to_string(n) + " points as by independent numbers",
          .source = "the same integral",
          .margin_factor = comparison.margin_factor,
          .check =
              [=](const Trial& trial) {
                const View view = view_of(settings);
                const TracedScene<Real> scene(view.scene);
                const auto tracer = chosen_tracer<Real>(Strategies(settings, view.scene), view.scene);
                const IndependentNumbers independent(StreamKey(trial.seed, trial.claim + " independent"));
                const Reference reference{0, comparison.darkest, comparison.brightest, 0, comparison.mean};
                return check_sets<Real, Numbers>(trial, {reference}, n, [&](const auto& numbers) {
                  auto camera = numbers.at(0);
                  const Vec2<Real> place = next_pair<Real>(camera);
                  const Path<Real> path{view.camera.template ray<Real>(place.x(), place.y(), 1, 1, camera)};
                  const PathNumbers<Real, IndependentNumbers> others{independent, numbers.pixel, numbers.sample};
                  return mean_channel(Rgb<Real>(followed<Real>(tracer, scene, path, numbers) -
                                                followed<Real>(tracer, scene, path, others)));
                });
              },
          .real = real_name<Real>()};
}

/// Adds these rows for Sobol' points and for strata.
template <class Real>
void add_sets(std::vector<Claim>& claims, const SceneComparison& comparison, const RenderSettings& settings) {
  const auto name = [&](RandomNumbers sets) {
    return formatted("%s.random.%s", comparison.scene.c_str(), name_of(sets));
  };
  claims.push_back(
      sets_agree<Real, PaddedSobol>(name(RandomNumbers::sobol), {"PaddedSobol"}, comparison, settings));
  claims.push_back(
      sets_agree<Real, PaddedStrata>(name(RandomNumbers::stratified), {"PaddedStrata"}, comparison, settings));
}

}  // namespace fairlight

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <fairlight/stats/evidence.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/checks/means.h>
#include <fairlight/validation/claims/relations.h>

namespace fairlight {

/// Compares strategies that must bring the same light along the same paths. Only the difference of
/// their estimates at each vertex remains. It varies so little that pictures are compared to 0.2 %.

/// The difference of two strategies for direct light. Both use the same random numbers.
template <class One, class Other>
struct DirectDifference {
  One one;
  Other other;

  template <class Real>
  Real emission_weight(const auto& scene, const Ray<Real>& ray, const Real& surface, const Real& density) const {
    return one.emission_weight(scene, ray, surface, density) - other.emission_weight(scene, ray, surface, density);
  }
  bool next_event_only() const { return one.next_event_only() && other.next_event_only(); }

  template <class Real, class Scene, class Source, class Bsdf>
  Rgb<Real> estimate(const Scene& scene, const Vertex<Real>& vertex, const Bsdf& bsdf, Source& source,
                     const Mask<Real>& asked) const {
    Source same = source;
    const Rgb<Real> found = one.template estimate<Real>(scene, vertex, bsdf, same, asked);
    return found - other.template estimate<Real>(scene, vertex, bsdf, source, asked);
  }
};

/// Tracers of the difference: direct light by `one` minus by `other`, all else as in `other`. A
/// fault can replace the direct light of `one`.
template <template <class> class One = ChosenDirect>
auto paired_tracers(const RenderSettings& one, const RenderSettings& other, const Scene& scene) {
  return [=]<class Real>(std::type_identity<Real>) {
    const Strategies strategies(other, scene);
    using Direct = DirectDifference<One<Real>, ChosenDirect<Real>>;
    return PathTracer<ChosenBounces, Direct, ChosenRoulette>(
        strategies.max_depth,
        Direct{One<Real>(Strategies(one, scene), scene), ChosenDirect<Real>(strategies, scene)},
        {strategies.bounce}, chosen_roulette(strategies));
  };
}

/// Parts of a picture, in columns: `place(c, u)` is a uniform point of part c. (0,0) is the upper
/// left corner of the picture.
struct WholePicture {
  static constexpr std::size_t columns = 1, parts = 1;
  template <class Real>
  static Vec2<Real> place(std::size_t /*c*/, const Vec2<Real>& u) {
    return u;
  }
};
template <std::size_t n>
struct PictureTiles {
  static constexpr std::size_t columns = n, parts = n * n;
  template <class Real>
  static Vec2<Real> place(std::size_t c, const Vec2<Real>& u) {
    const auto left = static_cast<Lane<Real>>(c % n), top = static_cast<Lane<Real>>(c / n);
    return Vec2<Real>(Real(left) + u.x(), Real(top) + u.y()) / Real(static_cast<Lane<Real>>(n));
  }
};
/// The outermost 8 pixels of 256: four strips, each from one corner to the next.
struct PictureBorder {
  static constexpr std::size_t columns = 1, parts = 1;
  template <class Real>
  static Vec2<Real> place(std::size_t /*c*/, const Vec2<Real>& u) {
    const Real width(1.0f / 32), far = Real(1) - width;
    const Real turn = Real(4) * u.x();
    const Mask<Real> upper = turn < Real(1), right = turn < Real(2), lower = turn < Real(3);
    const Real side = select(upper, Real(0), select(right, Real(1), select(lower, Real(2), Real(3))));
    const Real along = (turn - side) * far, across = u.y() * width;
    return {select(upper, along, select(right, Real(far + across), select(lower, Real(width + along), across))),
            select(upper, across, select(right, along, select(lower, Real(far + across), Real(width + along))))};
  }
};

/// The grey value of draw(ray, source) along camera rays through part c of the picture.
template <class Parts, class Draw>
auto over_part(const Camera& camera, std::size_t c, const Draw& draw) {
  return [=](std::type_identity<Packet>, auto& source) {
    const Vec2<Packet> place = Parts::place(c, next_pair<Packet>(source));
    return mean_channel(draw(camera.template ray<Packet>(place.x(), place.y(), 1, 1, source), source));
  };
}

/// The strategies to compare, the scene, and the range of the difference of their light
/// (one - other), in grey.
struct PairedPaths {
  std::string name, scene;
  RenderSettings one, other;
  double darkest, brightest;
};

/// Parts of a picture, with the means that the margins are relative to. They are at most what
/// surfaces reflect there, in grey.
struct PartMeans {
  std::string name, where;
  std::vector<double> means;
};

/// The finding of the whole from those of its parts: that with the largest bias among the worst
/// verdicts, and the sum of the draws.
inline Finding whole_of_parts(const std::vector<Finding>& parts) {
  Finding whole = parts.at(0);
  std::uint64_t draws = 0;
  for (const Finding& part : parts) {
    draws += part.draws;
    const bool worse_than_it = worse(part.verdict, whole.verdict) != whole.verdict;
    if (worse_than_it || (part.verdict == whole.verdict && !(std::abs(part.bias) <= std::abs(whole.bias))))
      whole = part;
  }
  whole.draws = draws;
  return whole;
}

/// Tests the mean of each part, with an equal share of alpha and with its own paths, so that the
/// number of paths can differ. If the trial is stopped, the remaining parts are left out, and add
/// no evidence to the margin grid.
template <class Parts, class Draw>
Finding check_parts(const Trial& trial, const Camera& camera, const std::vector<Reference>& references,
                    const Draw& draw) {
  std::vector<Finding> findings;
  bool ends = false;
  for (std::size_t c = 0; c < Parts::parts && !ends; ++c) {
    Trial part = trial;
    part.alpha /= Parts::parts;
    if (Parts::parts > 1) part.claim += formatted(" part %zu", c);
    part.watch = [&, c](double done) {
      ends = !goes_on(trial, (static_cast<double>(c) + done) / Parts::parts);
      return !ends;
    };
    const auto body = body_of<Packet>(over_part<Parts>(camera, c, draw));
    findings.push_back(check_mean_in_packets(part, {references.at(c)}, draws_of<Packet>(body, 1)));
  }
  if (trial.evidence != nullptr) {
    auto& channels = trial.evidence->margin_grid.channels;
    channels.resize(Parts::parts, std::vector<Wealth>(channels.at(0).size()));
  }
  return whole_of_parts(findings);
}

/// Stores the bias of each part in units of its margin as the tiles of the evidence; 0 for parts
/// that did not run.
inline void leave_tiles(const Trial& trial, const std::vector<double>& means, std::size_t columns) {
  Evidence::Tiles tiles{static_cast<int>(columns), std::vector<double>(means.size())};
  for (std::size_t c = 0; c < std::min(means.size(), trial.evidence->means.size()); ++c) {
    const auto& steps = trial.evidence->means[c].steps();
    if (!steps.empty()) tiles.biases[c] = steps.back().mean / (trial.margin * means[c]);
  }
  trial.evidence->tiles = tiles;
}

/// Tests the mean of the difference over each part of the picture. In packets only, as so many
/// paths take minutes in double.
template <class Parts, template <class> class One = ChosenDirect>
Claim paired_claim(const PairedPaths& paths, const PartMeans& parts, double margin_factor) {
  std::vector<Reference> references;
  for (const double mean : parts.means) references.push_back({0, paths.darkest, paths.brightest, 0, mean});
  const View view = built_in_scene(paths.scene);
  const RadianceAlong difference(view.scene, paired_tracers<One>(paths.one, paths.other, view.scene));
  const auto draw = [=](const Ray<Packet>& ray, auto& source) {
    return difference.along(ray, std::type_identity<Packet>{}, source);
  };
  return {.name = paths.scene + ".paired." + paths.name + "." + parts.name + real_suffix<Packet>(),
          .kind = "agreement",
          .subjects = {"PathTracer", "DirectLight"},
          .statement = parts.where + " of " + paths.scene + " both strategies have one mean, along the same paths",
          .source = "the same integral",
          .margin_factor = margin_factor,
          .check =
              [=, camera = view.camera](const Trial& trial) {
                const Finding finding = check_parts<Parts>(trial, camera, references, draw);
                if (trial.evidence != nullptr) leave_tiles(trial, parts.means, Parts::columns);
                return finding;
              },
          .real = real_name<Packet>()};
}

/// Tests that surfaces reflect at least these means into the parts of a picture. If they did not,
/// the margins above would be wider than stated.
template <class Parts>
Claim presumed_light(const PairedPaths& paths, const PartMeans& parts) {
  std::vector<Reference> references;
  for (const double mean : parts.means) references.push_back({mean, 0, -paths.darkest, 0, mean, Sides::not_below});
  const View view = built_in_scene(paths.scene);
  const ReflectedLight<> light(view, paths.other);
  const auto draw = [=](const Ray<Packet>& ray, auto& source) {
    return light.along(std::type_identity<Packet>{}, ray, source);
  };
  return {.name = paths.scene + ".paired.light." + parts.name + real_suffix<Packet>(),
          .kind = "mean",
          .subjects = {"PathTracer", "DirectLight"},
          .statement = parts.where + " of " + paths.scene + " surfaces reflect as much as margins are relative to",
          .source = "a declared bound, that was measured",
          .margin_factor = 20,
          .check = [=, camera = view.camera](
                       const Trial& trial) { return check_parts<Parts>(trial, camera, references, draw); },
          .real = real_name<Packet>()};
}

}  // namespace fairlight

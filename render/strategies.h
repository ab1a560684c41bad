#pragma once

#include <fairlight/estimators/blackman_harris_filter.h>
#include <fairlight/estimators/filter.h>
#include <fairlight/estimators/gaussian_filter.h>
#include <fairlight/estimators/padded_sobol.h>
#include <fairlight/estimators/padded_strata.h>
#include <fairlight/render/path_tracer.h>
#include <fairlight/render/settings.h>
#include <fairlight/render/strategy_table.h>

namespace fairlight {

/// The strategies of a path, chosen at run time. Each choice selects a component of the kit by a
/// branch that always goes the same way, which costs about a cycle of the hundreds per vertex.
struct Strategies {
  /// Throws std::invalid_argument for a strategy that the scene does not admit, and for paths that
  /// might not end or whose variance is infinite.
  Strategies(const RenderSettings& settings, const Scene& scene);

  BounceSampling bounce;
  DirectLighting direct;
  LightPoints light_sampling;
  WhichLight which_light;
  RouletteKind roulette;
  int roulette_depth;  ///< the first bounce that roulette may end
  PixelFilter filter;
  RandomNumbers random;
  std::uint32_t points;
  int max_depth;
};

/// Samples diffuse surfaces.
template <class Real>
struct ChosenDirections {
  using Scalar = Real;
  Vec3<Real> sample(const Vec2<Real>& u) const {
    return is_uniform ? UniformHemisphere<Real>().sample(u) : CosineHemisphere<Real>().sample(u);
  }
  Density<SolidAngle, Real> pdf(const Vec3<Real>& w) const {
    return is_uniform ? UniformHemisphere<Real>().pdf(w) : CosineHemisphere<Real>().pdf(w);
  }
  bool is_uniform = false;
};

struct ChosenBounces {
  template <class Real>
  ChosenDirections<Real> directions() const {
    return {bounce == BounceSampling::uniform};
  }
  BounceSampling bounce;
};

/// Samples points of a luminaire.
struct ChosenPoints {
  template <class Real>
  LightSample<Real> sample(const LightTable<Real>& lights, const Index<Real>& i, const Mask<Real>& on_it,
                           const Vec3<Real>& from, const Vec2<Real>& u) const {
    return with([&](auto points) { return points.template sample<Real>(lights, i, on_it, from, u); });
  }
  template <class Real>
  Density<SolidAngle, Real> pdf(const LightTable<Real>& lights, const Index<Real>& i, const Mask<Real>& on_it,
                                const Vec3<Real>& from, const Vec3<Real>& direction) const {
    return with([&](auto points) { return points.template pdf<Real>(lights, i, on_it, from, direction); });
  }

  LightPoints sampling;

 private:
  auto with(const auto& use) const {
    switch (sampling) {
      case LightPoints::visible:
        return use(PointsBy<SphereByVisibleHemisphere>());
      case LightPoints::cone:
        return use(PointsBy<SphereByCone>());
      case LightPoints::solid_angle:
        return use(PointsBy<SphereByArea, RectangleBySolidAngle>());
      case LightPoints::area:
        break;
    }
    return use(PointsBy<SphereByArea>());
  }
};

/// Selects all luminaires, or samples one.
template <class Real>
class ChosenLuminaires {
 public:
  ChosenLuminaires(const Strategies& strategies, const Scene& scene)
      : which_(strategies.which_light), by_power_(one_by_power<Real>(scene)) {}

  /// The choice of luminaires as seen from a point.
  auto seen_from(const LightTable<Real>& lights, const Vec3<Real>& point) const {
    return Seen{*this, lights, point};
  }

 private:
  struct Seen {
    WhichLight which(int n) const { return n == 1 ? WhichLight::all : chosen.which_; }

    template <class>
    Real probability(int n, const Index<Real>& i) const {
      switch (which(n)) {
        case WhichLight::one:
          return UniformLightSampler::probability<Real>(n, i);
        case WhichLight::power:
          return chosen.by_power_.template probability<Real>(n, i);
        case WhichLight::contribution:
          return ContributionLightSampler::seen_from(lights, point).template probability<Real>(n, i);
        case WhichLight::all:
          break;
      }
      return AllLights::probability<Real>(n, i);
    }

    template <class, class Source, class Term>
    auto sum(int n, Source& source, const Term& term) const {
      switch (which(n)) {
        case WhichLight::one:
          return UniformLightSampler::sum<Real>(n, source, term);
        case WhichLight::power:
          return chosen.by_power_.template sum<Real>(n, source, term);
        case WhichLight::contribution:
          return ContributionLightSampler::seen_from(lights, point).template sum<Real>(n, source, term);
        case WhichLight::all:
          break;
      }
      return AllLights::sum<Real>(n, source, term);
    }
    const ChosenLuminaires& chosen;
    const LightTable<Real>& lights;
    Vec3<Real> point;
  };

  WhichLight which_;
  LightSampler<PowerChoice<Real>> by_power_;
};

/// The weights of shadow rays and bounces.
struct ChosenSharing {
  bool next_event_only() const { return direct == DirectLighting::light; }
  template <class Real>
  Real weight(const std::array<Real, 2>& n, const std::array<Density<SolidAngle, Real>, 2>& p,
              std::size_t i) const {
    return next_event_only() ? NextEventOnly::weight(n, p, i) : BalanceHeuristic::weight(n, p, i);
  }
  DirectLighting direct;
};

/// Direct light by shadow rays, or none.
template <class Real>
class ChosenDirect {
 public:
  ChosenDirect(const Strategies& strategies, const Scene& scene)
      : direct_(ChosenLuminaires<Real>(strategies, scene), {strategies.light_sampling}, {strategies.direct}),
        none_(strategies.direct == DirectLighting::none) {}

  Real emission_weight(const auto& scene, const Ray<Real>& ray, const Real& surface, const Real& density) const {
    return none_ ? Real(1) : direct_.emission_weight(scene, ray, surface, density);
  }
  bool next_event_only() const { return direct_.next_event_only(); }

  template <class, class Scene, class Source, class Bsdf>
  Rgb<Real> estimate(const Scene& scene, const Vertex<Real>& vertex, const Bsdf& bsdf, Source& source,
                     const Mask<Real>& asked) const {
    return none_ ? zero<Rgb<Real>>() : direct_.template estimate<Real>(scene, vertex, bsdf, source, asked);
  }

 private:
  DirectLight<ChosenLuminaires<Real>, ChosenPoints, ChosenSharing> direct_;
  bool none_;
};

/// Decides whether a path goes on; from the first bounce that roulette may end.
struct ChosenRouletteKind {
  template <class Real, class Source>
  Survival<Real> play(const Rgb<Real>& albedo, const Rgb<Real>& throughput, const Real& depth,
                      Source& source) const {
    switch (kind) {
      case RouletteKind::throughput:
        return RouletteByThroughput<>::play<Real>(albedo, throughput, depth, source);
      case RouletteKind::off:
        return NoRoulette::play<Real>(albedo, throughput, depth, source);
      case RouletteKind::albedo:
        break;
    }
    return RouletteByReflectance<>::play<Real>(albedo, throughput, depth, source);
  }
  RouletteKind kind;
};

using ChosenRoulette = RouletteFromBounce<ChosenRouletteKind>;

inline ChosenRoulette chosen_roulette(const Strategies& strategies) {
  return ChosenRoulette(strategies.roulette_depth, {strategies.roulette});
}

/// The pixel filter.
template <class Real>
class ChosenFilter {
 public:
  using Scalar = Real;
  explicit ChosenFilter(PixelFilter filter) : filter_(filter) {}

  Vec2<Real> sample(const Vec2<Real>& u) const {
    switch (filter_) {
      case PixelFilter::box:
        return box_.sample(u);
      case PixelFilter::gaussian:
        return gaussian_.sample(u);
      case PixelFilter::blackman_harris:
        return blackman_harris_.sample(u);
      case PixelFilter::tent:
        break;
    }
    return TentFilter<Real>().sample(u);
  }

 private:
  PixelFilter filter_;
  BoxFilter<Real> box_;
  GaussianFilter<Real> gaussian_{Real(0.5f), Real(1.5f)};
  BlackmanHarrisFilter<Real> blackman_harris_{Real(2)};
};

/// The source of random numbers.
class ChosenNumbers {
 public:
  ChosenNumbers(const Strategies& strategies, const StreamKey& key)
      : random_(strategies.random),
        independent_(key),
        sobol_(key, strategies.points),
        strata_(key, strategies.points) {}

  template <class Real>
  SampleBlock<Real> block(const PathVertex<Real>& at, std::uint32_t b, BlockPart part) const {
    if (random_ == RandomNumbers::independent) [[likely]]
      return independent_.block(at, b, part);
    return block_of_set(at, b, part);
  }

 private:
  /// Not inlined, so that it does not slow down independent numbers.
  template <class Real>
  [[gnu::noinline, gnu::flatten]] SampleBlock<Real> block_of_set(const PathVertex<Real>& at, std::uint32_t b,
                                                                 BlockPart part) const {
    return random_ == RandomNumbers::sobol ? sobol_.block(at, b, part) : strata_.block(at, b, part);
  }

  RandomNumbers random_;
  IndependentNumbers independent_;
  PaddedSobol sobol_;
  PaddedStrata strata_;
};

/// The path tracer with these strategies.
template <class Real>
auto chosen_tracer(const Strategies& strategies, const Scene& scene) {
  return PathTracer<ChosenBounces, ChosenDirect<Real>, ChosenRoulette>(
      strategies.max_depth, ChosenDirect<Real>(strategies, scene), {strategies.bounce},
      chosen_roulette(strategies));
}

}  // namespace fairlight

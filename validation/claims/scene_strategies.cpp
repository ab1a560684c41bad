#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/claims/scene_agreements.h>
#include <fairlight/validation/claims/scene_relations.h>

namespace fairlight {
namespace {

// The most that a path brings, in grey: `baseline` by the shadow rays of the baseline, without
// roulette; `uniform`, `shared` and `estimated` by the strategies of these rows; `light` is the
// emission of the luminaires. `shared_baseline` differs where the row "shared" has another
// baseline, because the choice of a light is expensive.
struct Most {
  double baseline, uniform, shared, estimated, light, shared_baseline = baseline;
};

// A built-in scene, and the parameters of its comparisons. `mean` is at most the mean of its
// picture, in grey.
struct WholeScene {
  std::string name;
  WhichLight which_light = WhichLight::all;
  LightPoints light_sampling = LightPoints::cone;
  int max_depth = 3;
  Most most;
  double mean;
  double margin_factor;
  double alone_factor = 1;  // factor on the margin of the row where only bounces find lights; 0: no such row
  double float_factor = margin_factor;
  bool by_sets = true;  // whether this file compares its sets of numbers

  RenderSettings baseline() const { return related_settings(light_sampling, which_light, max_depth); }
  SceneComparison comparison(double brightest, double factor = 1) const {
    return {name, max_depth, -most.baseline, brightest, mean, factor * margin_factor};
  }
};

// Bounds of a path, in grey: at each vertex what shadow rays bring, and once what a bounce finds.
// The roulette before the bounce can cancel the factor of the albedo. A bounce multiplies by at
// most 1, or by 2 for uniform bounces. So three vertices count as 3, or as 7, and what the bounce
// at the last one finds counts as 1, or as 4. See also built_in_scenes.cpp.
//   cornell-simple     2.49 by cone; by the visible hemisphere 6, found 6 / 0.75; by area 12, found
//                      16; four vertices, which count as 15 for uniform bounces
//   cornell-complex    2.6; one of two counts twice
//   cornell-materials  16; a bounce finds at most 25, also if it shares, and the light in a mirror;
//                      through glass n^2 = 2.25 times as much
//   cornell-original   15.8; shared 7.9 and found 11, twice that for uniform bounces
//   hallway            12.4; shared 24 and found 30, twice that for uniform bounces; 13 by
//                      contribution
//   many-lights        6; by power 2 pi r^2 f / d^2 sum Le = 80, found 100; one of them 0.8 Le
//                      = 123, found 154
std::vector<WholeScene> whole_scenes() {
  return {
      {.name = "cornell-simple",
       .max_depth = 4,
       .most = {2.49 * 2.952, 6 * 15 + 8 * 8, 12 * 4 + 16, 2.49 * 15, 400},
       .mean = 0.4,
       .margin_factor = 20,
       .alone_factor = 3,
       .float_factor = 1,
       .by_sets = false},
      {.name = "cornell-complex",
       .most = {2.6 * 2.44, 2 * (6.1 * 7 + 8.1 * 4), 2 * (12.1 * 3 + 16.1), 2.6 * 7, 400},
       .mean = 0.4,
       .margin_factor = 30,
       .alone_factor = 3},
      {.name = "cornell-materials",
       .most = {2 * 16 + 5 + 25, 50 * (7 + 4), 2.25 * 25 * (3 + 1), 2.25 * (16 * 7 + 25 * 4), 27},
       .mean = 0.3,
       .margin_factor = 40},
      {.name = "cornell-original",
       .light_sampling = LightPoints::solid_angle,
       .most = {15.8 * 2.44, 2 * (7.9 * 7 + 11 * 4), 7.9 * 3 + 11, 15.8 * 7, 11},
       .mean = 0.11,
       .margin_factor = 60},
      {.name = "hallway",
       .most = {12.4 * 2.44, 2 * (24 * 7 + 30 * 4), 24 * 3 + 30, 13 * 7, 30},
       .mean = 0.2,
       .margin_factor = 40},
      {.name = "many-lights",
       .which_light = WhichLight::contribution,
       .max_depth = 1,
       .most = {6, 80 + 100, 123 + 154, 6 * (1 + 2), 154, 80},
       .mean = 0.3,
       .margin_factor = 60,
       .alone_factor = 0,
       .by_sets = false},
  };
}

struct WaysOfAPath {
  BounceSampling bounce;
  DirectLighting direct;
  LightPoints light_sampling;
  WhichLight which_light;
  RouletteKind roulette;
};

RenderSettings settings_of(const WaysOfAPath& ways) {
  RenderSettings settings;
  settings.bounce = ways.bounce;
  settings.direct = ways.direct;
  settings.light_sampling = ways.light_sampling;
  settings.which_light = ways.which_light;
  settings.roulette = ways.roulette;
  if (ways.roulette == RouletteKind::throughput) settings.roulette_depth = 1;
  return settings;
}

// Compares every strategy of each kind in four rows of a scene, so that a wrong one shows in one of
// them. The rows are in packets; add_floats tests the error of packets. If bounces find no light,
// paths need a second vertex for the first bounce to matter. Bounces that alone find small bright
// lights vary much: those rows have wider margins, and there is none among a thousand lights.
void add_strategies(std::vector<Claim>& claims, const WholeScene& scene) {
  const LightPoints part = scene.light_sampling == LightPoints::cone ? LightPoints::visible : LightPoints::area;
  const auto add = [&](const std::string& name, const SceneComparison& comparison, const WaysOfAPath& ways,
                       const RenderSettings& baseline) {
    claims.push_back(
        mean_claim<Packet>(strategies_agree(scene.name + ".strategies." + name, {"PathTracer", "DirectLight"},
                                            comparison, settings_of(ways), baseline)));
  };
  const RenderSettings baseline = scene.baseline();
  add("uniform", scene.comparison(scene.most.uniform),
      {BounceSampling::uniform, DirectLighting::mis, part, WhichLight::power, RouletteKind::albedo}, baseline);
  SceneComparison shared = scene.comparison(scene.most.shared);
  shared.darkest = -scene.most.shared_baseline;
  RenderSettings by_power = baseline;
  if (scene.which_light == WhichLight::contribution) by_power.which_light = WhichLight::power;
  add("shared", shared,
      {BounceSampling::cosine, DirectLighting::mis, LightPoints::area, WhichLight::one, RouletteKind::throughput},
      by_power);
  SceneComparison estimated = scene.comparison(scene.most.estimated);
  if (scene.max_depth == 1) {
    estimated.max_depth = 2;
    estimated.darkest *= 1.8;
  }
  add("estimated", estimated,
      {BounceSampling::uniform, DirectLighting::light, scene.light_sampling, WhichLight::contribution,
       RouletteKind::throughput},
      baseline);
  claims.push_back(mean_claim<Packet>(presumed_mean(scene.name + ".strategies.mean", scene.comparison(0),
                                                    scene.most.baseline + scene.most.light, baseline)));
  if (scene.alone_factor == 0) return;
  add("alone", scene.comparison(scene.most.light, scene.alone_factor),
      {BounceSampling::cosine, DirectLighting::none, LightPoints::area, WhichLight::all, RouletteKind::albedo},
      baseline);
}

// The picture in floats: the light that surfaces reflect. The margin is relative to half of the
// mean of the picture.
void add_floats(std::vector<Claim>& claims, const WholeScene& scene) {
  RenderSettings settings = scene.baseline();
  settings.scene = scene.name;
  const View view = view_of(settings);
  const auto tracer = [&](int max_depth) {
    settings.max_depth = max_depth;
    const auto make = [scene = view.scene, settings]<class Real>(std::type_identity<Real>) {
      return ChosenTracer<Real>(settings, scene);
    };
    return RadianceAlong(view.scene, Ray<double>{{0, 0, 0}, {0, 0, 1}, -1}, make);
  };
  const auto grey = [](const auto& colour) { return (colour[0] + colour[1] + colour[2]) / 3; };
  const auto seen = [=, light = tracer(0)](auto real, const auto& ray, auto& source) {
    return grey(light.along(ray, real, source));
  };
  const auto reflected = [=, all = tracer(scene.max_depth)](auto real, const auto& ray, auto& source) {
    return grey(all.along(ray, real, source)) - seen(real, ray, source);
  };
  if (scene.name == "cornell-simple")
    claims.push_back(floats_against_double(scene.name + ".float.light", view, scene.most.light, scene.mean / 2,
                                           scene.float_factor, seen, around_the_light_of_cornell_simple));
  claims.push_back(floats_against_double(scene.name + ".float.reflected", view, scene.most.baseline, scene.mean / 2,
                                         scene.float_factor, reflected));
}

// Compares sets of numbers, with a light picked by contribution, which may bring 5 % more than all
// lights. built_in_scenes.cpp compares those of cornell-simple at a finer margin. A thousand lights
// are picked as three are, but take a hundred times as long, so they have no row.
void add_numbers(std::vector<Claim>& claims, const WholeScene& scene) {
  if (!scene.by_sets) return;
  RenderSettings settings = scene.baseline();
  settings.which_light = WhichLight::contribution;
  SceneComparison comparison = scene.comparison(1.05 * scene.most.baseline, 1.6);
  comparison.darkest = -comparison.brightest;
  add_sets<Packet>(claims, comparison, settings);
}

}  // namespace

void add_scene_strategy_claims(std::vector<Claim>& claims) {
  for (const WholeScene& scene : whole_scenes()) {
    add_strategies(claims, scene);
    add_floats(claims, scene);
    add_numbers(claims, scene);
  }
}

}  // namespace fairlight

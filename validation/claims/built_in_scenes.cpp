#include <fairlight/validation/agreements/scene_agreements.h>
#include <fairlight/validation/claims/claims.h>

namespace fairlight {
namespace {

// Shadow rays to all luminaires, to points that they show, and paths of a fixed length: what the others are compared to.
RenderSettings baseline(const std::string& light_sampling) {
  RenderSettings settings;
  settings.light_sampling = light_sampling;
  settings.which_light = "all";
  settings.roulette = "off";
  return settings;
}

// Paths are short, so it begins at their second bounce.
void play_by_throughput(RenderSettings& settings) {
  settings.roulette = "throughput";
  settings.roulette_depth = 2;
}

// One luminaire of several, chosen in each of these ways.
void add_which_light(std::vector<Claim>& claims, const SceneComparison& scene, const std::string& sampling,
                     const std::vector<std::string>& ways) {
  for (const std::string& which : ways) {
    RenderSettings settings = baseline(sampling);
    settings.which_light = which;
    settings.roulette = "albedo";
    if (which == "power") play_by_throughput(settings);
    add_independent_mean(claims, strategies_agree(scene.scene + ".which." + which, {"PathTracer", "DirectLight"},
                                                  scene, settings, baseline(sampling)));
  }
}

// Shadow rays and bounces that share the light; and, where bounces find it often enough, bounces alone.
void add_bounces(std::vector<Claim>& claims, const SceneComparison& scene, const std::string& sampling,
                 bool alone) {
  const auto add = [&](const std::string& direct) {
    RenderSettings settings = baseline(sampling);
    settings.direct = direct;
    settings.which_light = "one";
    add_independent_mean(claims, strategies_agree(scene.scene + ".direct." + direct, {"PathTracer", "DirectLight"},
                                                  scene, settings, baseline(sampling)));
  };
  add("mis");
  if (alone) add("none");
}

// The picture in floats: the light itself, which differs at its rim alone, and what the surfaces reflect of it, up to four
// bounces, by cone. Each within the margin of half of the picture's mean.
void add_floats(std::vector<Claim>& claims, const SceneComparison& scene) {
  RenderSettings settings = baseline("cone");
  settings.scene = scene.scene;
  settings.max_depth = scene.max_depth;
  const View view = view_of(settings);
  const auto tracer = [&](int max_depth) {
    settings.max_depth = max_depth;
    const auto make = [scene = view.scene, settings]<class Real>(std::type_identity<Real>) {
      return chosen_tracer<Real>(Strategies(settings, scene), scene);
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
  claims.push_back(floats_against_double(scene.scene + ".float.light", view, 400, scene.mean / 2, seen,
                                         around_the_light_of_cornell_simple));
  claims.push_back(
      floats_against_double(scene.scene + ".float.reflected", view, scene.largest, scene.mean / 2, reflected));
}

}  // namespace

// What a shadow ray brings is at most S f Le, by cone and by solid angle, and A f Le / d^2 by area; a bounce that shares
// brings no more, as the densities add up, and nothing where it meets a light so near to its rim that the shadow rays' density is
// rounded to nothing. Throughputs are at most 1.02, by the lobe of exponent 40.
void add_built_in_scene_claims(std::vector<Claim>& claims) {
  // A light of radius 1.5 is nowhere nearer than 15 to what it lights: 9 Le f pi / 15^2 = 12.8 by area, four times a path, for each.
  SceneComparison simple{"cornell-simple", 4, 4 * 12.8, 0.4, 10};
  for (const std::string sampling : {"area", "visible"}) {
    RenderSettings settings = baseline(sampling);
    play_by_throughput(settings);
    add_independent_mean(
        claims, strategies_agree("cornell-simple.sampling." + sampling, {"PathTracer", "DirectLight"}, simple,
                                 baseline("cone"), settings));
  }
  // By cone S f Le, with S = pi (1.5 / 15)^2, four times: 12.8 as well.
  add_floats(claims, {"cornell-simple", 4, 12.8, 0.4, 1});
  claims.push_back(cornell_by_sets<double, PaddedSobol>("sobol", "PaddedSobol"));
  claims.push_back(cornell_by_sets<Packet, PaddedSobol>("sobol", "PaddedSobol"));
  claims.push_back(cornell_by_sets<double, PaddedStrata>("stratified", "PaddedStrata"));
  claims.push_back(cornell_by_sets<Packet, PaddedStrata>("stratified", "PaddedStrata"));
  simple.margin_factor = 20;
  add_bounces(claims, simple, "cone", false);
  // Two such lights; of equal powers at the distances 15 and 150 the fainter is chosen with 1/101 at least, and brings then
  // S f Le = 0.008 at most: less than the nearer one.
  SceneComparison complex{"cornell-complex", 4, 4 * 2 * 12.8, 0.4, 30};
  add_which_light(claims, complex, "area", {"one", "power", "contribution"});
  add_bounces(claims, complex, "cone", false);
  // Rough metal: f cos <= D / (2 alpha) <= 1 / (2 pi 0.25^3) = 10.2, of a light of radius 6 that is 44 away, S < 0.06, so 16; gloss
  // 4 x 0.05 x 25 = 5; the ceiling 0.43 x 25 x 0.8 / pi = 2.8; and the light itself, 25, seen in a mirror or through glass.
  const SceneComparison materials{"cornell-materials", 5, 5 * 16 + 25, 0.3, 40};
  add_bounces(claims, materials, "cone", true);
  // All of a hemisphere at most: 2 pi 17 x 0.725 / pi = 25; a bounce brings at most 17.
  const SceneComparison original{"cornell-original", 4, 4 * 25, 0.2, 40};
  add_bounces(claims, original, "solid-angle", true);
  // Lights of radius 4, of which the ceiling is 6 away: S = 2 pi (1 - sqrt(1 - 4^2 / 6^2)) = 1.6, so 1.6 x 30 x 0.8 / pi = 12.3 by cone,
  // three times for one of three; their power is the same, so a choice by power is one of three too.
  const SceneComparison balls{"hallway", 3, 3 * 3 * 12.3, 0.2, 40};
  add_which_light(claims, balls, "cone", {"one", "contribution"});
  add_bounces(claims, balls, "cone", false);
  // Lights of radius r = 0.15, at least 4.6 from what they light. One is chosen with w / sum w, w = Le / d^2, so that by area it brings
  // at most 4 pi r^2 Le f / d^2 sum w / w = 0.07 sum w, which is less than 7 x 2 + 64 by the nearest and the others, spread evenly.
  const SceneComparison many{"many-lights", 1, 6, 0.1, 80};
  RenderSettings by_cone = baseline("cone"), by_area = baseline("area");
  by_cone.which_light = by_area.which_light = "contribution";
  add_independent_mean(claims, strategies_agree("many-lights.which.contribution", {"PathTracer", "DirectLight"},
                                                many, by_cone, by_area));
}

}  // namespace fairlight

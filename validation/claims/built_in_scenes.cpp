#include <fairlight/stats/text.h>
#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/claims/scene_agreements.h>
#include <fairlight/validation/claims/scene_relations.h>

namespace fairlight {
namespace {

// Bounds are for one vertex, in grey. A shadow ray brings at most S f Le by cone and by solid
// angle, and A f Le / d^2 by area. A bounce that shares the light brings no more, as the densities
// add up. It does so once, as lights are black. One of n luminaires counts n times. From one vertex
// to the next the throughput falls by 0.8 or less, the largest albedo; after a roulette it is at
// most 1.
constexpr double three_vertices = 1 + 0.8 + 0.64, of_four = three_vertices + 0.512;

// The settings that others are compared with: shadow rays to all luminaires, and paths of a fixed
// length.
RenderSettings baseline(LightPoints light_sampling) {
  return related_settings(light_sampling, WhichLight::all, -1);
}

// Roulette by throughput, from the second bounce on, as paths are short.
void play_by_throughput(RenderSettings& settings) {
  settings.roulette = RouletteKind::throughput;
  settings.roulette_depth = 2;
}

void add_agreement(std::vector<Claim>& claims, const std::string& name, const SceneComparison& scene,
                   const RenderSettings& settings, LightPoints sampling) {
  add_independent_mean(claims, strategies_agree(scene.scene + "." + name, {"PathTracer", "DirectLight"}, scene,
                                                settings, baseline(sampling)));
}

// One luminaire, picked by `which`.
void add_which_light(std::vector<Claim>& claims, const SceneComparison& scene, LightPoints sampling,
                     WhichLight which) {
  RenderSettings settings = baseline(sampling);
  settings.which_light = which;
  settings.roulette = RouletteKind::albedo;
  if (which == WhichLight::power) play_by_throughput(settings);
  add_agreement(claims, formatted("which.%s", name_of(which)), scene, settings, sampling);
}

// Bounces that share the light with shadow rays to one luminaire, or that find it alone.
void add_bounces(std::vector<Claim>& claims, const SceneComparison& scene, LightPoints sampling,
                 DirectLighting direct) {
  RenderSettings settings = baseline(sampling);
  settings.direct = direct;
  settings.which_light = WhichLight::one;
  add_agreement(claims, formatted("direct.%s", name_of(direct)), scene, settings, sampling);
}

// By cone 2.49, by area 12, by the visible hemisphere 6: see in_the_box (paired_boxes.h).
void add_box_claims(std::vector<Claim>& claims) {
  constexpr double by_cone = 2.49 * of_four;
  const auto add_sampling = [&](LightPoints sampling, double most) {
    RenderSettings settings = baseline(sampling);
    play_by_throughput(settings);
    add_agreement(claims, formatted("sampling.%s", name_of(sampling)),
                  {"cornell-simple", 4, -by_cone, 4 * most, 0.4, 10}, settings, LightPoints::cone);
  };
  add_sampling(LightPoints::area, 12);
  add_sampling(LightPoints::visible, 6);
  const SceneComparison sets{"cornell-simple", 4, -by_cone, by_cone, 0.4, 20};
  add_sets<double>(claims, sets, baseline(LightPoints::cone));
  add_sets<Packet>(claims, sets, baseline(LightPoints::cone));
  add_bounces(claims, {"cornell-simple", 4, -by_cone, by_cone + 2.49, 0.4, 20}, LightPoints::cone,
              DirectLighting::mis);
}

// Two such lights, 80 apart. The ceiling bulges and is 9 mm nearer to them. A point near one light
// gets at most 0.42 from the other by area, and 0.1 by cone.
void add_complex_box_claims(std::vector<Claim>& claims) {
  constexpr double by_area = 12.5 * of_four, by_cone = 2.6 * of_four;
  add_which_light(claims, {"cornell-complex", 4, -by_area, 4 * 24.1, 0.4, 30}, LightPoints::area, WhichLight::one);
  add_which_light(claims, {"cornell-complex", 4, -by_area, 4 * 24.1, 0.4, 30}, LightPoints::area,
                  WhichLight::power);
  // The centres are 16.5 and 81.7 away, so the weights are 25 to 1: 12 (1 + 1/25) and 0.42
  // (1 + 25).
  add_which_light(claims, {"cornell-complex", 4, -by_area, 4 * 12.6, 0.4, 30}, LightPoints::area,
                  WhichLight::contribution);
  add_bounces(claims, {"cornell-complex", 4, -by_cone, 2 * 2.5 * (of_four + 1), 0.4, 30}, LightPoints::cone,
              DirectLighting::mis);
}

// Rough metal: f cos <= D / (2 alpha) <= 1 / (2 pi 0.25^3) = 10.2; a light of radius 6 that is 44
// away has S < 0.06, so it brings 16. Gloss: 4 x 0.05 x 25 = 5. The ceiling:
// 0.43 x 25 x 0.8 / pi = 2.8. A ball does not see itself, so at most three of five vertices are
// metal. In a mirror or through glass the light itself shows, 25, also after three bounces of gloss
// of at most 1.0244 each (exponent 40).
void add_material_box_claims(std::vector<Claim>& claims) {
  constexpr double shadow_rays = 3 * 16 + 2 * 5 + 25;
  add_bounces(claims, {"cornell-materials", 5, -shadow_rays, shadow_rays, 0.3, 40}, LightPoints::cone,
              DirectLighting::mis);
  add_bounces(claims, {"cornell-materials", 5, -shadow_rays, 27, 0.3, 40}, LightPoints::cone, DirectLighting::none);
}

// By solid angle 15.8. A bounce finds albedo Le = 7.9, and a shadow ray that shares the light
// brings no more: see measured_box (paired_boxes.h).
void add_measured_box_claims(std::vector<Claim>& claims) {
  add_bounces(claims, {"cornell-original", 4, -15.8 * of_four, 7.9 * (of_four + 1), 0.11, 60},
              LightPoints::solid_angle, DirectLighting::mis);
  add_bounces(claims, {"cornell-original", 4, -15.8 * of_four, 7.9, 0.11, 60}, LightPoints::solid_angle,
              DirectLighting::none);
}

// Lights of radius 4, 110 apart, about 6 from the ceiling: S = 2 pi
// (1 - sqrt(1 - 4^2 / 6^2)) = 1.6, so by cone 1.6 x 30 x 0.8 / pi = 12.3, and 12.4 with the other
// lights. Picked in proportion to 1/d^2, at most 13. Where bounces and shadow rays share the light,
// each brings at most albedo Le = 24.
void add_hallway_claims(std::vector<Claim>& claims) {
  constexpr double all = 12.4 * three_vertices;
  add_which_light(claims, {"hallway", 3, -all, 3 * 3 * 12.3, 0.2, 40}, LightPoints::cone, WhichLight::one);
  add_which_light(claims, {"hallway", 3, -all, 3 * 13, 0.2, 40}, LightPoints::cone, WhichLight::contribution);
  add_bounces(claims, {"hallway", 3, -all, 24 * (three_vertices + 1), 0.2, 40}, LightPoints::cone,
              DirectLighting::mis);
}

// Lights of radius r = 0.15, at least 4.6 from the surfaces. One is picked with the probability
// w / sum w, w = Le / d^2. So by area it brings at most 4 pi r^2 Le f / d^2 sum w / w = 0.07 sum w.
// The sum is less than 7 x 2 for the nearest light and 64 for the others, evenly spread.
void add_many_lights_claims(std::vector<Claim>& claims) {
  RenderSettings by_cone = baseline(LightPoints::cone), by_area = baseline(LightPoints::area);
  by_cone.which_light = by_area.which_light = WhichLight::contribution;
  add_independent_mean(claims, strategies_agree("many-lights.which.contribution", {"PathTracer", "DirectLight"},
                                                {"many-lights", 1, -6, 6, 0.3, 25}, by_cone, by_area));
}

}  // namespace

void add_built_in_scene_claims(std::vector<Claim>& claims) {
  add_box_claims(claims);
  add_complex_box_claims(claims);
  add_material_box_claims(claims);
  add_measured_box_claims(claims);
  add_hallway_claims(claims);
  add_many_lights_claims(claims);
}

}  // namespace fairlight

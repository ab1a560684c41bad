#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/claims/pairwise_cover.h>
#include <fairlight/validation/claims/rendered_radiance.h>

namespace fairlight {
namespace {

RenderSettings settings_in(Arithmetic real, const LightSearch& search, int depth) {
  RenderSettings settings;
  settings.real = real;
  settings.direct = search.direct;
  settings.light_sampling = search.light_sampling;
  settings.max_depth = depth;
  return settings;
}

// Objects that reflect all light, under a sky; and pictures of few samples and of twice as many.
void add_renders(std::vector<Claim>& claims, Arithmetic real) {
  RenderSettings endless = settings_in(real, {DirectLighting::none, LightPoints::area}, -1);
  for (const RouletteKind roulette : {RouletteKind::albedo, RouletteKind::throughput}) {
    endless.roulette = roulette;
    claims.push_back(rendered_radiance(white_sky(), endless, 1));
  }
  for (const LightSearch& search : searches_of_spheres()) {
    claims.push_back(rendered_radiance(white_ball(), settings_in(real, search, 1)));
  }
  for (const std::uint32_t sets : {3u, 6u}) {
    claims.push_back(rendered_radiance(concentric_spheres(),
                                       settings_in(real, {DirectLighting::light, LightPoints::cone}, 5), 30, sets));
  }
}

}  // namespace

void add_closed_scene_claims(std::vector<Claim>& claims) {
  const auto add = [&](const ClosedScene& scene, const std::vector<LightSearch>& searches) {
    for (const RenderSettings& row : PairwiseCover(searches, 5).rows()) {
      claims.push_back(rendered_radiance(scene, row));
    }
  };
  add(concentric_spheres(), searches_of_spheres());
  add(lit_box(), searches_of_rectangles());
  for (const auto& row : StrategyTable<Arithmetic>::rows) add_renders(claims, row.value);
  using BySolidAngle = PointsBy<SphereByArea, RectangleBySolidAngle>;
  add_independent_mean(claims, in_lit_box<DirectLight<AllLights, BySolidAngle>>("direct"));
  add_independent_mean(claims, in_lit_box<DirectLight<AllLights, BySolidAngle, MisWeighted<>>>("shared"));
}

}  // namespace fairlight

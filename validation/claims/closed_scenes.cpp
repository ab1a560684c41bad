#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/claims/pairwise_cover.h>
#include <fairlight/validation/claims/rendered_radiance.h>

namespace fairlight {
namespace {

RenderSettings settings_in(const std::string& real, const LightSearch& search, int depth) {
  RenderSettings settings;
  settings.real = real;
  settings.direct = search.direct;
  settings.light_sampling = search.light_sampling;
  settings.max_depth = depth;
  return settings;
}

// Objects that reflect all light, under a sky; and pictures of few samples and of twice as many.
void add_renders(std::vector<Claim>& claims, const std::string& real) {
  RenderSettings endless = settings_in(real, {"none", "area"}, -1);
  for (const char* roulette : {"albedo", "throughput"}) {
    endless.roulette = roulette;
    claims.push_back(rendered_radiance(white_sky(), endless, 1));
  }
  for (const LightSearch& search : searches_of_spheres()) {
    claims.push_back(rendered_radiance(white_ball(), settings_in(real, search, 1)));
  }
  for (const std::uint32_t sets : {3u, 6u}) {
    claims.push_back(rendered_radiance(concentric_spheres(), settings_in(real, {"light", "cone"}, 5), 30, sets));
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
  add_renders(claims, "double");
  add_renders(claims, "packet");
  using BySolidAngle = PointsBy<SphereByArea, RectangleBySolidAngle>;
  add_independent_mean(claims, in_lit_box<DirectLight<AllLights, BySolidAngle>>("direct"));
  add_independent_mean(claims, in_lit_box<DirectLight<AllLights, BySolidAngle, MisWeighted<>>>("shared"));
}

}  // namespace fairlight

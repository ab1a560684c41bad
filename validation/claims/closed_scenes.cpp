#include <fairlight/validation/analytic/rendered_radiance.h>
#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/strategy_cross.h>

namespace fairlight {

void add_closed_scene_claims(std::vector<Claim>& claims) {
  const auto add = [&](const ClosedScene& scene, const std::vector<LightSearch>& searches) {
    for (const RenderSettings& row : StrategyCross(searches, 5).rows()) {
      claims.push_back(rendered_radiance(scene, row));
    }
  };
  add(concentric_spheres(), searches_of_spheres);
  add(lit_box(), searches_of_rectangles);
  using BySolidAngle = PointsBy<SphereByArea, RectangleBySolidAngle>;
  add_independent_mean(claims, in_lit_box<DirectLight<AllOf, BySolidAngle>>("direct"));
  add_independent_mean(claims, in_lit_box<DirectLight<AllOf, BySolidAngle, Shared<>>>("shared"));
}

}  // namespace fairlight

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
  add(concentric_spheres(), {{"none", "area"},
                             {"light", "area"},
                             {"light", "visible"},
                             {"light", "cone"},
                             {"mis", "area"},
                             {"mis", "visible"},
                             {"mis", "cone"}});
  // By area alone the variance is infinite: points of two faces are as near to each other as can be.
  add(lit_box(), {{"none", "area"}, {"light", "solid-angle"}, {"mis", "solid-angle"}, {"mis", "area"}});
  add_independent_mean(claims, lit_box_direct());
}

}  // namespace fairlight
